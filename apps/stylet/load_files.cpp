#include "apps/stylet/load_files.h"

#include "apps/stylet/csv_cell.h"
#include "apps/stylet/load_advice.h"
#include "apps/stylet/load_text.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace stylet::app {
namespace {

using nlohmann::ordered_json;

/// JSON has no infinity.
ordered_json number(double value) {
    return std::isfinite(value) ? ordered_json(value) : ordered_json(nullptr);
}

ordered_json number(const std::optional<double>& value) {
    return value ? number(*value) : ordered_json(nullptr);
}

ordered_json numbers(const std::vector<double>& values) {
    ordered_json json = ordered_json::array();
    for (const double value : values) json.push_back(number(value));
    return json;
}

ordered_json needle_json(const SceneLoads& scene) {
    const NeedleSetup& needle = scene.needle;
    return {{"type", scene.needle_type},
            {"length", needle.length},
            {"radius", needle.radius},
            {"inner_radius", needle.inner_radius},
            {"gauge", scene.gauge.empty() ? ordered_json(nullptr) : ordered_json(scene.gauge)},
            {"youngs_modulus", needle.youngs_modulus},
            {"ends", word_of(needle.ends)},
            {"buckling_model_in_runs", scene.has_buckling},
            {"bending_stiffness", needle.bending_stiffness()}};
}

ordered_json curve_json(const LoadCurve& curve, const SceneLoads& scene, const CriticalLoads& loads) {
    const LoadAdvice advice = advice_on(curve, scene, loads);
    ordered_json json{{"model", curve.model},
                      {"load", numbers(curve.loads)},
                      {"stiffness", curve.stiffness.empty() ? ordered_json(nullptr) : numbers(curve.stiffness)},
                      {"load_at_surface", number(curve.at_surface)},
                      {"buckles_first", advice.buckles_first ? ordered_json(*advice.buckles_first) : ordered_json(nullptr)},
                      {"crossings", numbers(curve.crossings)},
                      {"inside_crossings", numbers(curve.inside_crossings)},
                      {"least_load", number(advice.least)},
                      {"least_at", number(advice.least_at)}};
    if (scene.reference) json["deviation"] = number(curve.loads.front() / *scene.reference - 1.0);
    return json;
}

/// What is no number has an empty cell.
std::string value(double number) {
    return std::isnan(number) ? "" : fmt::format("{}", number);
}

std::string heading(const std::string& name, const std::string& unit) {
    return csv_cell(unit.empty() ? name : fmt::format("{} [{}]", name, unit));
}

}    // namespace

std::string loads_json(const CriticalLoads& loads) {
    ordered_json scenes = ordered_json::array();
    for (const SceneLoads& scene : loads.scenes) {
        ordered_json curves = ordered_json::array();
        for (const LoadCurve& curve : scene.curves) curves.push_back(curve_json(curve, scene, loads));
        scenes.push_back({{"scene", scene.file},
                          {"title", scene.title},
                          {"hash", scene.hash},
                          {"needle", loads.along_depth ? needle_json(scene) : ordered_json(nullptr)},
                          {"reference", number(scene.reference)},
                          {"axis", numbers(scene.points)},
                          {"puncture_force", numbers(scene.puncture)},
                          {"insertion_force", numbers(scene.insertion)},
                          {"models", curves}});
    }
    const ordered_json units{
        {"length", "m"}, {"radius", "m"},     {"inner_radius", "m"}, {"youngs_modulus", "Pa"}, {"bending_stiffness", "N m^2"},
        {"load", "N"},   {"stiffness", "Pa"}, {"depth", "m"},        {"puncture_force", "N"},  {"insertion_force", "N"}};
    const ordered_json json{{"units", units},
                            {"axis", {{"name", loads.axis}, {"unit", loads.unit}}},
                            {"depth", loads.along_depth ? ordered_json(nullptr) : number(loads.depth)},
                            {"scenes", scenes}};
    return json.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

std::string loads_csv(const CriticalLoads& loads) {
    const std::vector<std::string> models = loads.models();
    std::string text = "scene," + heading(loads.axis, loads.unit) + ",puncture [N],insertion [N]";
    for (const std::string& model : models) {
        text += "," + heading(model, "N");
        if (loads.stiffness) text += "," + heading(model + " mu", "Pa");
    }
    const bool known = loads.scenes.front().reference.has_value();
    if (known) {
        text += ",known [N]";
        for (const std::string& model : models) text += "," + csv_cell(model + " deviation");
    }
    text += "\n";
    for (const SceneLoads& scene : loads.scenes) {
        for (std::size_t i = 0; i < scene.points.size(); ++i) {
            text += fmt::format("{},{},{},{}", csv_cell(scene.name), scene.points[i], scene.puncture[i], scene.insertion[i]);
            for (const std::string& model : models) {
                const LoadCurve* const curve = scene.curve(model);
                text += "," + (curve == nullptr ? "" : value(curve->loads[i]));
                if (loads.stiffness) text += "," + (curve == nullptr ? "" : value(curve->stiffness[i]));
            }
            if (known) {
                text += fmt::format(",{}", *scene.reference);
                for (const std::string& model : models) {
                    const LoadCurve* const curve = scene.curve(model);
                    text += "," + (curve == nullptr ? "" : value(curve->loads[i] / *scene.reference - 1.0));
                }
            }
            text += "\n";
        }
    }
    return text;
}

}    // namespace stylet::app
