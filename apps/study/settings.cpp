#include "apps/study/settings.h"

#include "apps/study/changes.h"
#include "apps/study/interval.h"
#include "core/scene/units.h"

#include <stylet/error.h>

#include <fmt/format.h>

namespace stylet::study {
namespace {

std::string label_of(const Vary& vary, const std::string& value) {
    std::string label = vary.label;
    const std::string shown = shown_value(value);
    for (std::size_t at = label.find("{}"); at != std::string::npos; at = label.find("{}", at + shown.size()))
        label.replace(at, 2, shown);
    return label;
}

/// A value of the key that orders are fitted in, in the unit of the key's first value. Throws core::SceneErrors where it is no
/// number, or of another dimension.
double fitted_number(const Vary& vary, const std::string& value) {
    try {
        const std::string unit = read_interval(shown_value(vary.values.front())).unit;
        const core::Quantity quantity = core::read_quantity(shown_value(value), unit.empty() ? "1" : unit);
        if (!quantity.problem.empty()) throw Error("found " + quantity.problem);
        return quantity.value;
    } catch (const Error& error) {
        throw core::SceneErrors(
            {fmt::format("{}: {}, wanted numbers of one dimension where an order is fitted", vary.given, error.what())});
    }
}

Setting with(Setting setting, const Vary& vary, const std::string& value, const std::string& fitted) {
    const std::string label = label_of(vary, value);
    setting.label += setting.label.empty() || label.empty() ? label : ", " + label;
    setting.changes = joined(setting.changes, {{.key = vary.key, .value = value, .given = vary.given}});
    if (vary.key == fitted) setting.fitted = fitted_number(vary, value);
    return setting;
}

}    // namespace

std::string shown_value(const std::string& yaml) {
    std::string shown;
    int depth = 0;    // of lists
    for (std::size_t i = 0; i < yaml.size(); ++i) {
        const char c = yaml[i];
        depth += c == '[' ? 1 : c == ']' ? -1 : 0;
        const bool between = c == ',' && depth > 0;
        if (between) shown += "×";
        if (between && i + 1 < yaml.size() && yaml[i + 1] == ' ') ++i;
        if (!between && c != '"' && c != '[' && c != ']' && c != '\\') shown += c;
    }
    return shown;
}

std::vector<Setting> settings_of(const Study& study) {
    std::vector<Setting> settings;
    for (const Series& series : study.series) {
        const std::vector<core::Override> changes = joined(joined({}, study.changes), series.changes);
        std::vector<Setting> combined{
            {.series = series.name, .label = "", .scene = series.scene, .of_series = changes, .changes = changes}};
        for (const Vary& vary : series.vary) {
            std::vector<Setting> next;
            for (const Setting& setting : combined) {
                for (const std::string& value : vary.values) next.push_back(with(setting, vary, value, study.fit_order));
            }
            combined = std::move(next);
        }
        settings.insert(settings.end(), combined.begin(), combined.end());
    }
    return settings;
}

}    // namespace stylet::study
