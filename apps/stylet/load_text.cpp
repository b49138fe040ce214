#include "apps/stylet/load_text.h"

#include "apps/stylet/load_advice.h"
#include "apps/stylet/table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace stylet::app {
namespace {

using Align = Table::Align;

constexpr std::size_t page_width = 120;    // [characters]

std::string per_cent(double value, double of) {
    const std::string text = fmt::format("{:+.1f} %", 100.0 * (value / of - 1.0));
    return text == "-0.0 %" || text == "+0.0 %" ? "0.0 %" : text;
}

/// A table with a column of places, a column for each model, and what goes beside the load there.
class LoadTable {
public:
    struct Beside {
        bool reference;            // known loads
        bool stiffness;            // Eq. (3)'s
        std::string force = "";    // what the needle has to bear, by this name, and whether it does; empty: neither
    };

    LoadTable(const std::vector<std::string>& models, const Beside& beside)
        : models_(models), beside_(beside), table_(columns()) {}

    /// A model's name, and below it what it was asked with.
    void add_header(const std::string& first) {
        std::vector<std::string> names{first}, changes{""};
        if (beside_.reference) names.emplace_back("known");
        if (!beside_.force.empty()) names.push_back(beside_.force);
        changes.resize(names.size());
        bool any = false;
        for (const std::string& model : models_) {
            const std::size_t blank = model.find(' ');
            names.push_back(model.substr(0, blank));
            changes.push_back(blank == std::string::npos ? "" : model.substr(blank + 1));
            any |= blank != std::string::npos;
            for (std::size_t i = 1; i < columns_a_model(); ++i) names.emplace_back(beside_.stiffness && i == 1 ? "µ" : "");
            changes.resize(names.size());
        }
        table_.add(names);
        if (any) table_.add(changes);
    }

    void add_row(const std::string& place, const SceneLoads& scene, std::size_t point) {
        std::vector<std::string> row{place};
        if (beside_.reference) row.push_back(scene.reference ? significant(*scene.reference, "N") : "");
        const double force = scene.points[point] > 0.0 ? scene.insertion[point] : scene.puncture[point];
        if (!beside_.force.empty()) row.push_back(significant(force, "N"));
        for (const std::string& model : models_) {
            const LoadCurve* const curve = scene.curve(model);
            row.push_back(curve == nullptr ? "" : significant(curve->loads[point], "N"));
            if (beside_.stiffness) row.push_back(curve == nullptr ? "" : significant(curve->stiffness[point], "Pa"));
            if (!beside_.force.empty())
                row.emplace_back(curve == nullptr || std::isnan(curve->loads[point]) || !std::isfinite(force) ? ""
                                 : curve->loads[point] < force                                                ? "buckles"
                                                                                                              : "bears");
            if (beside_.reference) row.push_back(curve && scene.reference ? per_cent(curve->loads[point], *scene.reference) : "");
        }
        table_.add(row);
    }

    [[nodiscard]] std::string text() const { return table_.text(2); }

private:
    [[nodiscard]] std::size_t columns_a_model() const {
        return 1 + (beside_.stiffness ? 1 : 0) + (beside_.force.empty() ? 0 : 1) + (beside_.reference ? 1 : 0);
    }
    [[nodiscard]] std::vector<Align> columns() const {
        const std::size_t first = 1 + (beside_.reference ? 1 : 0) + (beside_.force.empty() ? 0 : 1);
        std::vector<Align> columns(first + models_.size() * columns_a_model(), Align::right);
        columns.front() = Align::left;
        return columns;
    }

    const std::vector<std::string>& models_;
    Beside beside_;
    Table table_;
};

bool with_reference(const CriticalLoads& loads) {
    return loads.scenes.front().reference.has_value();
}

std::string needle_text(const SceneLoads& scene) {
    const NeedleSetup& needle = scene.needle;
    const std::string bore = needle.inner_radius > 0.0 ? fmt::format(", inner radius {:.4g} mm", 1e3 * needle.inner_radius) : "";
    return fmt::format("{}, {:.4g} mm long, radius {:.4g} mm{}{}, {:.4g} GPa, {}", scene.needle_type, 1e3 * needle.length,
                       1e3 * needle.radius, bore, scene.gauge.empty() ? "" : fmt::format(" ({})", scene.gauge),
                       1e-9 * needle.youngs_modulus, word_of(needle.ends));
}

std::string heading(const SceneLoads& scene, const CriticalLoads& loads) {
    Table facts({Align::left, Align::left});
    facts.add({"scene", scene.file});
    if (loads.along_depth) {
        facts.add({"needle", needle_text(scene)});
        if (!scene.has_buckling)
            facts.add({"", "given no buckling model by its scene: in a run it buckles by itself or not at all"});
        const bool limited = std::isfinite(scene.puncture.front());
        if (scene.has_tissue)
            facts.add({"tip", limited ? "punctures at " + significant(scene.puncture.front(), "N")
                                      : "never punctures: no effect limits it"});
    } else if (loads.depth > 0.0) {
        facts.add({"inserted", fmt::format("{:.4g} mm", 1e3 * loads.depth)});
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
    LoadTable table(models, {.reference = scene.reference.has_value(), .stiffness = loads.stiffness});
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
    const bool inside = loads.scenes.front().points.front() > 0.0;
    const bool limited = std::ranges::any_of(loads.scenes, [&](const SceneLoads& scene) {
        return std::isfinite((inside ? scene.insertion : scene.puncture).front());
    });
    LoadTable table(models, {.reference = with_reference(loads),
                             .stiffness = loads.stiffness,
                             .force = !limited ? ""
                                      : inside ? "insertion"
                                               : "puncture"});
    table.add_header("scene");
    for (const SceneLoads& scene : loads.scenes) table.add_row(scene.name, scene, 0);
    return fmt::format("Critical loads with {} inserted\n", on_axis(loads.scenes.front().points.front(), loads)) + table.text();
}

}    // namespace

std::string word_of(Ends ends) {
    switch (ends) {
        case Ends::clamped_free:
            return "clamped-free";
        case Ends::pinned_pinned:
            return "pinned-pinned";
        case Ends::clamped_pinned:
            return "clamped-pinned";
        case Ends::clamped_clamped:
            break;
    }
    return "clamped-clamped";
}

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
