#include "apps/stylet/load_advice.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace stylet::app {
namespace {

/// "up to 2 mm and from 5 mm on": every other stretch between the crossings, the first of them or the second to begin with.
std::string stretches(const std::vector<double>& crossings, bool from_the_beginning, const CriticalLoads& loads) {
    std::vector<std::string> words;
    std::size_t i = 0;
    if (from_the_beginning) words.push_back("up to " + on_axis(crossings[i++], loads));
    for (; i < crossings.size(); i += 2) {
        const bool ends = i + 1 < crossings.size();
        words.push_back(
            fmt::format("from {} {}", on_axis(crossings[i], loads), ends ? "to " + on_axis(crossings[i + 1], loads) : "on"));
    }
    return fmt::format("{}", fmt::join(words, " and "));
}

/// How the load inside compares with the puncture force where that is not how it is on the surface; empty where it is.
std::string change_inside(const LoadCurve& curve, const LoadAdvice& advice, const SceneLoads& scene, const CriticalLoads& loads) {
    if (curve.loads.size() == 1) return "";
    const bool surface_less = *advice.buckles_first, begins_less = curve.loads.front() < scene.puncture.front();
    const char* const other = surface_less ? "more" : "less";
    if (!curve.crossings.empty())
        return fmt::format(" Inside it bears {} than that {}.", other,
                           stretches(curve.crossings, begins_less != surface_less, loads));
    if (begins_less != surface_less)
        return fmt::format(" From {} to {} it bears {} than that.", on_axis(scene.points.front(), loads),
                           on_axis(scene.points.back(), loads), other);
    return surface_less ? " Inside it nowhere bears that." : "";
}

/// Of a needle that goes in, from its tip on the surface on.
std::string along_depth(const LoadCurve& curve, const LoadAdvice& advice, const SceneLoads& scene, const CriticalLoads& loads) {
    const std::string buckles = significant(*curve.at_surface, "N"), punctures = significant(scene.puncture.front(), "N");
    if (std::ranges::none_of(curve.loads, [](double load) { return std::isfinite(load); })) return "the needle never buckles.";
    std::string text;
    if (!advice.buckles_first) {
        text = fmt::format("the needle buckles at {}{}.", buckles, scene.has_tissue ? ", its tip on the surface" : "");
    } else {
        text = *advice.buckles_first
                   ? fmt::format("the needle buckles at {}, before its tip punctures at {}.", buckles, punctures)
                   : fmt::format("the tip punctures at {}, before the needle buckles at {}.", punctures, buckles);
        text += change_inside(curve, advice, scene, loads);
    }
    if (curve.loads.size() > 1 && advice.least < *curve.at_surface)
        text += fmt::format(" Its least load is {}, at {}.", significant(advice.least, "N"), on_axis(advice.least_at, loads));
    return text;
}

std::string along_key(const LoadCurve& curve, const LoadAdvice& advice, const SceneLoads& scene, const CriticalLoads& loads) {
    if (!advice.buckles_first) {
        return fmt::format("the needle buckles at {} where {} is {}, at {} where it is {}.",
                           significant(curve.loads.front(), "N"), loads.axis, on_axis(scene.points.front(), loads),
                           significant(curve.loads.back(), "N"), on_axis(scene.points.back(), loads));
    }
    if (!curve.crossings.empty()) {
        return fmt::format("the needle buckles before its tip punctures where {} is {}.", loads.axis,
                           stretches(curve.crossings, *advice.buckles_first, loads));
    }
    return *advice.buckles_first ? "the needle buckles before its tip punctures, all along."
                                 : "the tip punctures before the needle buckles, all along.";
}

}    // namespace

LoadAdvice advice_on(const LoadCurve& curve, const SceneLoads& scene, const CriticalLoads& loads) {
    const auto least = std::ranges::min_element(curve.loads);
    LoadAdvice advice{
        .buckles_first = {}, .least = *least, .least_at = scene.points[static_cast<std::size_t>(least - curve.loads.begin())]};
    const bool at_surface = loads.along_depth || loads.depth == 0.0;
    const bool limited = std::ranges::any_of(scene.puncture, [](double force) { return std::isfinite(force); });
    if (!at_surface || !limited) return advice;
    advice.buckles_first = curve.at_surface.value_or(curve.loads.front()) < scene.puncture.front();
    return advice;
}

std::string advice_text(const LoadCurve& curve, const SceneLoads& scene, const CriticalLoads& loads) {
    const LoadAdvice advice = advice_on(curve, scene, loads);
    return fmt::format("{}: {}", curve.model,
                       loads.along_depth ? along_depth(curve, advice, scene, loads) : along_key(curve, advice, scene, loads));
}

std::string significant(double value, const std::string& unit) {
    if (!std::isfinite(value)) return "unlimited";
    constexpr int digits = 4, most_decimals = 9;
    const int before_the_point = value == 0.0 ? 1 : static_cast<int>(std::floor(std::log10(std::abs(value)))) + 1;
    return fmt::format("{:.{}f} {}", value, std::clamp(digits - before_the_point, 0, most_decimals), unit);
}

std::string on_axis(double value, const CriticalLoads& loads) {
    return loads.unit.empty() ? fmt::format("{:.4g}", value) : fmt::format("{:.4g} {}", value, loads.unit);
}

}    // namespace stylet::app
