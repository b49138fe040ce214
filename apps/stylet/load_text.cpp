#include "apps/stylet/load_text.h"

#include "apps/stylet/load_advice.h"
#include "apps/stylet/table.h"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>

namespace stylet::app {
namespace {

using Align = Table::Align;

constexpr std::size_t page_width = 120;    // [characters]

std::string stem(const SceneLoads& scene) {
    return std::filesystem::path(scene.file).stem().string();
}

std::string per_cent(double value, double of) {
    return fmt::format("{:+.1f} %", 100.0 * (value / of - 1.0));
}

/// A table with a column of places, a column for each model, and what goes beside the load there.
class LoadTable {
public:
    LoadTable(const std::vector<std::string>& models, bool reference, bool stiffness)
        : models_(models), reference_(reference), stiffness_(stiffness), table_(columns()) {}

    /// A model's name, and below it what it was asked with.
    void add_header(const std::string& first) {
        std::vector<std::string> names{first}, changes{""};
        if (reference_) {
            names.emplace_back("known");
            changes.emplace_back();
        }
        bool any = false;
        for (const std::string& model : models_) {
            const std::size_t blank = model.find(' ');
            names.push_back(model.substr(0, blank));
            changes.push_back(blank == std::string::npos ? "" : model.substr(blank + 1));
            any |= !changes.back().empty();
            for (std::size_t i = 1; i < columns_a_model(); ++i) {
                names.emplace_back(stiffness_ && i == 1 ? "µ" : "");
                changes.emplace_back();
            }
        }
        table_.add(names);
        if (any) table_.add(changes);
    }

    void add_row(const std::string& place, const SceneLoads& scene, std::size_t point) {
        std::vector<std::string> row{place};
        if (reference_) row.push_back(scene.reference ? significant(*scene.reference, "N") : "");
        for (const std::string& model : models_) {
            const LoadCurve* const curve = scene.curve(model);
            row.push_back(curve == nullptr ? "" : significant(curve->loads[point], "N"));
            if (stiffness_) row.push_back(curve == nullptr ? "" : significant(curve->stiffness[point], "Pa"));
            if (reference_) row.push_back(curve && scene.reference ? per_cent(curve->loads[point], *scene.reference) : "");
        }
        table_.add(row);
    }

    [[nodiscard]] std::string text() const { return table_.text(2); }

private:
    [[nodiscard]] std::size_t columns_a_model() const { return 1 + (stiffness_ ? 1 : 0) + (reference_ ? 1 : 0); }
    [[nodiscard]] std::vector<Align> columns() const {
        std::vector<Align> columns((reference_ ? 2 : 1) + models_.size() * columns_a_model(), Align::right);
        columns.front() = Align::left;
        return columns;
    }

    const std::vector<std::string>& models_;
    bool reference_;
    bool stiffness_;
    Table table_;
};

bool with_stiffness(const CriticalLoads& loads) {
    return !loads.scenes.front().curves.front().stiffness.empty();
}

bool with_reference(const CriticalLoads& loads) {
    return loads.scenes.front().reference.has_value();
}

std::string needle_text(const SceneLoads& scene) {
    const NeedleSetup& needle = scene.needle;
    const std::string bore = needle.inner_radius > 0.0 ? fmt::format(", inner radius {:.4g} mm", 1e3 * needle.inner_radius) : "";
    return fmt::format("{:.4g} mm long, radius {:.4g} mm{}{}", 1e3 * needle.length, 1e3 * needle.radius, bore,
                       scene.gauge.empty() ? "" : fmt::format(" ({})", scene.gauge));
}

std::string heading(const SceneLoads& scene, const CriticalLoads& loads) {
    Table facts({Align::left, Align::left});
    facts.add({"scene", scene.file});
    if (loads.along_depth) {
        facts.add({"needle", needle_text(scene)});
        const bool limited = std::isfinite(scene.puncture.front());
        if (scene.has_tissue)
            facts.add({"tip", limited ? "punctures at " + significant(scene.puncture.front(), "N")
                                      : "never punctures: no effect limits it"});
    } else if (loads.depth > 0.0) {
        facts.add({"depth", fmt::format("{:.4g} mm", 1e3 * loads.depth)});
    }
    return scene.title + "\n" + facts.text(2) + "\n";
}

/// Of many points some, evenly chosen, both ends among them.
std::string points_text(const SceneLoads& scene, const CriticalLoads& loads) {
    constexpr std::size_t most = 21, shown = 11;
    const std::size_t count = scene.points.size();
    const std::size_t rows = count > most ? shown : count;
    const std::vector<std::string> models = [&] {
        std::vector<std::string> names;
        for (const LoadCurve& curve : scene.curves) names.push_back(curve.model);
        return names;
    }();
    LoadTable table(models, scene.reference.has_value(), !scene.curves.front().stiffness.empty());
    table.add_header(loads.axis);
    for (std::size_t row = 0; row < rows; ++row) {
        const std::size_t point = rows == 1 ? 0 : (row * (count - 1) + (rows - 1) / 2) / (rows - 1);
        table.add_row(on_axis(scene.points[point], loads), scene, point);
    }
    const std::string rest = rows < count ? fmt::format("  {} of {} points; --csv FILE has all\n", rows, count) : "";
    return table.text() + rest;
}

std::string scenes_text(const CriticalLoads& loads) {
    const std::vector<std::string> models = loads.models();
    LoadTable table(models, with_reference(loads), with_stiffness(loads));
    table.add_header("scene");
    for (const SceneLoads& scene : loads.scenes) table.add_row(stem(scene), scene, 0);
    return fmt::format("Critical loads at {} of depth\n", on_axis(loads.scenes.front().points.front(), loads)) + table.text();
}

}    // namespace

std::string loads_text(const CriticalLoads& loads) {
    if (loads.one_point() && loads.scenes.size() > 1) return scenes_text(loads);
    std::string text;
    for (const SceneLoads& scene : loads.scenes) {
        text += (text.empty() ? "" : "\n") + heading(scene, loads) + points_text(scene, loads) + "\n";
        for (const LoadCurve& curve : scene.curves) text += wrapped(advice_text(curve, scene, loads), 2, page_width);
    }
    return text;
}

}    // namespace stylet::app
