#include "apps/stylet/load_advice.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace stylet::app {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

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

/// "Inside", or what of it was asked for.
std::string where(const SceneLoads& scene, const CriticalLoads& loads) {
    if (loads.whole) return "Inside";
    if (scene.points.front() == 0.0) return "Up to " + on_axis(scene.points.back(), loads);
    return fmt::format("From {} to {}", on_axis(scene.points.front(), loads), on_axis(scene.points.back(), loads));
}

/// Where a needle that would buckle on the surface bears more than the puncture force inside, held until it is in.
std::string more_inside(const LoadCurve& curve, const SceneLoads& scene, const CriticalLoads& loads) {
    const bool begins_more = curve.loads.front() >= scene.puncture.front();
    if (!curve.crossings.empty())
        return fmt::format(" {} bears more than that {}.", loads.whole ? "Inside it" : "It",
                           stretches(curve.crossings, begins_more, loads));
    return fmt::format(" {} it {} that.", where(scene, loads), begins_more ? "bears more than" : "nowhere bears");
}

/// What the way in asks for, and whether the needle bears it; empty where nothing lets the needle go on.
std::string bears_inside(const LoadCurve& curve, const SceneLoads& scene, const CriticalLoads& loads) {
    double least = infinity, greatest = 0.0;
    for (const double force : scene.insertion) {
        if (!std::isfinite(force)) continue;
        least = std::min(least, force);
        greatest = std::max(greatest, force);
    }
    if (!std::isfinite(least)) return "";
    const std::string from = significant(least, "N"), to = significant(greatest, "N");
    const std::string asks = fmt::format(" {}, cutting and friction ask for {}", where(scene, loads),
                                         from == to ? from : fmt::format("{} to {}", from, to));
    const bool begins_less = curve.loads.front() < scene.insertion.front();
    if (curve.inside_crossings.empty()) return asks + (begins_less ? ", which it nowhere bears." : ", which it bears.");
    return fmt::format("{}: it buckles {}.", asks, stretches(curve.inside_crossings, begins_less, loads));
}

std::string on_surface(const LoadCurve& curve, const LoadAdvice& advice, const SceneLoads& scene) {
    const std::string buckles = significant(*curve.at_surface, "N"), punctures = significant(scene.puncture.front(), "N");
    if (!advice.buckles_first)
        return fmt::format("the needle buckles at {}{}.", buckles, scene.has_tissue ? ", its tip on the surface" : "");
    return *advice.buckles_first ? fmt::format("the needle buckles at {}, before its tip punctures at {}.", buckles, punctures)
                                 : fmt::format("the tip punctures at {}, before the needle buckles at {}.", punctures, buckles);
}

/// Of the one depth that was asked for, and then of the surface.
std::string at_depth(const LoadCurve& curve, const LoadAdvice& advice, const SceneLoads& scene, const CriticalLoads& loads) {
    const double load = curve.loads.front(), force = scene.insertion.front();
    std::string text = fmt::format("with {} inserted ", on_axis(scene.points.front(), loads));
    if (std::isnan(load)) {
        text += "none of the needle is in air, of which alone this model knows.";
    } else {
        text += fmt::format("the needle buckles at {}", significant(load, "N"));
        if (std::isfinite(force))
            text += fmt::format(", and cutting and friction ask for {}, which it {}", significant(force, "N"),
                                load < force ? "does not bear" : "bears");
        text += ".";
    }
    return fmt::format("{} On the surface {}", text, on_surface(curve, advice, scene));
}

/// Of a needle that goes in, from its tip on the surface on.
std::string along_depth(const LoadCurve& curve, const LoadAdvice& advice, const SceneLoads& scene, const CriticalLoads& loads) {
    if (std::ranges::none_of(curve.loads, [](double load) { return std::isfinite(load); }) && std::isinf(*curve.at_surface))
        return "the needle never buckles.";
    if (curve.loads.size() == 1 && scene.points.front() > 0.0) return at_depth(curve, advice, scene, loads);
    std::string text = on_surface(curve, advice, scene);
    if (curve.loads.size() == 1) return text;
    if (advice.buckles_first && *advice.buckles_first) text += more_inside(curve, scene, loads);
    text += bears_inside(curve, scene, loads);
    if (advice.least < *curve.at_surface)
        text += fmt::format(" Its least load is {}, at {}.", significant(advice.least, "N"), on_axis(advice.least_at, loads));
    return text;
}

/// The same to every digit that a sum may be trusted for.
bool constant(const std::vector<double>& values) {
    constexpr double rounding = 1e-12;    // relative
    return std::ranges::all_of(values, [&](double value) {
        return value == values.front() || std::abs(value - values.front()) <= rounding * std::abs(values.front());
    });
}

std::string along_key(const LoadCurve& curve, const SceneLoads& scene, const CriticalLoads& loads) {
    const bool outside = loads.depth == 0.0;
    const std::vector<double>& forces = outside ? scene.puncture : scene.insertion;
    if (constant(curve.loads) && (constant(forces) || !std::isfinite(forces.front())))
        return fmt::format("the load of {} does not depend on {}.", significant(curve.loads.front(), "N"), loads.axis);
    if (!std::isfinite(forces.front())) {
        return fmt::format("the needle buckles at {} where {} is {}, at {} where it is {}.",
                           significant(curve.loads.front(), "N"), loads.axis, on_axis(scene.points.front(), loads),
                           significant(curve.loads.back(), "N"), on_axis(scene.points.back(), loads));
    }
    const char* const buckles = outside ? "the needle buckles before its tip punctures" : "the needle buckles before it goes on";
    const char* const bears = outside ? "the tip punctures before the needle buckles" : "the needle bears what takes it on";
    const bool begins_less = curve.loads.front() < forces.front();
    const std::vector<double>& crossings = outside ? curve.crossings : curve.inside_crossings;
    if (!crossings.empty())
        return fmt::format("{} where {} is {}.", buckles, loads.axis, stretches(crossings, begins_less, loads));
    return fmt::format("{}, all along ({} to {}).", begins_less ? buckles : bears, on_axis(scene.points.front(), loads),
                       on_axis(scene.points.back(), loads));
}

}    // namespace

LoadAdvice advice_on(const LoadCurve& curve, const SceneLoads& scene, const CriticalLoads& loads) {
    std::size_t least = 0;
    for (std::size_t i = 1; i < curve.loads.size(); ++i) {
        if (std::isnan(curve.loads[least]) || curve.loads[i] < curve.loads[least]) least = i;
    }
    LoadAdvice advice{.buckles_first = {}, .least = curve.loads[least], .least_at = scene.points[least]};
    const bool at_surface = loads.along_depth || loads.depth == 0.0;
    const bool limited = std::ranges::any_of(scene.puncture, [](double force) { return std::isfinite(force); });
    if (!at_surface || !limited) return advice;
    advice.buckles_first = curve.at_surface.value_or(curve.loads.front()) < scene.puncture.front();
    return advice;
}

std::string advice_text(const LoadCurve& curve, const SceneLoads& scene, const CriticalLoads& loads) {
    const LoadAdvice advice = advice_on(curve, scene, loads);
    return fmt::format("{}: {}", curve.model,
                       loads.along_depth ? along_depth(curve, advice, scene, loads) : along_key(curve, scene, loads));
}

std::string significant(double value, const std::string& unit) {
    if (std::isnan(value)) return "–";
    if (std::isinf(value)) return "unlimited";
    if (value == 0.0) return "0 " + unit;
    constexpr int digits = 4, most_decimals = 7;
    struct Prefix {
        const char* name;
        double factor;
    };
    constexpr Prefix prefixes[] = {{"", 1.0}, {"µ", 1e-6}};
    for (const auto& [name, factor] : prefixes) {
        const double shown = value / factor;
        if (std::abs(shown) < 1e-3) continue;
        const int before_the_point = static_cast<int>(std::floor(std::log10(std::abs(shown)))) + 1;
        return fmt::format("{:.{}f} {}{}", shown, std::clamp(digits - before_the_point, 0, most_decimals), name, unit);
    }
    return fmt::format("{:.{}e} {}", value, digits - 1, unit);
}

std::string on_axis(double value, const CriticalLoads& loads) {
    return loads.unit.empty() ? fmt::format("{:.4g}", value) : fmt::format("{:.4g} {}", value, loads.unit);
}

}    // namespace stylet::app
