#include "apps/study/settings.h"

#include <charconv>

namespace stylet::study {
namespace {

std::string label_of(const Vary& vary, const std::string& value) {
    std::string label = vary.label;
    const std::size_t place = label.find("{}");
    if (place != std::string::npos) label.replace(place, 2, shown_value(value));
    return label;
}

std::optional<double> number_in(const std::string& value) {
    const std::string text = shown_value(value);
    double number = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    return error == std::errc{} ? std::optional(number) : std::nullopt;
}

Setting with(Setting setting, const Vary& vary, const std::string& value, const std::string& fitted) {
    const std::string label = label_of(vary, value);
    setting.label += setting.label.empty() || label.empty() ? label : ", " + label;
    setting.changes.push_back({.key = vary.key, .value = value, .given = vary.given});
    if (vary.key == fitted) setting.fitted = number_in(value);
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
        std::vector<core::Override> changes = study.changes;
        changes.insert(changes.end(), series.changes.begin(), series.changes.end());
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
