#include "apps/stylet/load_figure.h"

#include "apps/stylet/failure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace stylet::app {
namespace {

constexpr double kilo = 1e3;

std::string with_unit(std::string words, const std::string& unit) {
    return unit.empty() ? words : fmt::format("{} ({})", words, unit);
}

Curve curve_of(const std::string& name, const std::vector<double>& x, const std::vector<double>& y, double factor) {
    Curve curve{.name = name, .points = {}, .marks = {}};
    for (std::size_t i = 0; i < x.size(); ++i) {
        if (std::isfinite(y[i])) curve.points.push_back({x[i], factor * y[i]});
    }
    return curve;
}

double greatest(const Curve& curve) {
    double y = 0.0;
    for (const Point& point : curve.points) y = std::max(y, point.y);
    return y;
}

/// The load of what little is in air at last has no bound: a picture of an insertion ends at some multiples of what is usual.
double ceiling(const std::vector<Curve>& curves, const SceneLoads& scene) {
    constexpr double multiples = 3.0, above_puncture = 1.5;
    std::vector<double> all;
    for (const Curve& curve : curves) {
        for (const Point& point : curve.points) all.push_back(point.y);
    }
    const auto middle = all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2);
    std::nth_element(all.begin(), middle, all.end());
    const double puncture = std::isfinite(scene.puncture.front()) ? scene.puncture.front() : 0.0;
    return std::max(multiples * *middle, above_puncture * puncture);
}

/// Ends the curve where it leaves below `top`.
void cut(Curve& curve, double top) {
    const auto over = std::ranges::find_if(curve.points, [top](const Point& point) { return point.y > top; });
    if (over == curve.points.end() || over == curve.points.begin()) return;
    const Point &before = *(over - 1), &after = *over;
    const double share = (top - before.y) / (after.y - before.y);
    *over = {std::lerp(before.x, after.x, share), top};
    curve.points.erase(over + 1, curve.points.end());
}

bool agree(const Curve& one, const Curve& other, double height) {
    constexpr double near = 0.01;    // of the picture's height
    if (one.points.size() != other.points.size()) return false;
    for (std::size_t i = 0; i < one.points.size(); ++i) {
        if (!(std::abs(one.points[i].y - other.points[i].y) <= near * height)) return false;
    }
    return true;
}

/// Markers that don't touch each other.
void space_out(Curve& curve, const Figure& figure) {
    constexpr double apart = 0.035;    // of the picture
    std::vector<Point> kept;
    for (const Point& point : curve.points) {
        const bool far = kept.empty() || std::hypot((point.x - kept.back().x) / (figure.greatest.x - figure.least.x),
                                                    (point.y - kept.back().y) / (figure.greatest.y - figure.least.y)) > apart;
        if (far) kept.push_back(point);
    }
    curve.points = std::move(kept);
}

void dot_what_agrees(std::vector<Curve>& curves) {
    double height = 0.0;
    for (const Curve& curve : curves) height = std::max(height, greatest(curve));
    for (std::size_t i = 1; i < curves.size(); ++i) {
        for (std::size_t j = 0; j < i && !curves[i].dotted; ++j)
            curves[i].dotted = !curves[j].dotted && agree(curves[i], curves[j], height);
    }
}

/// What tells this curve from the others: its model, its scene, or both.
std::string name_of(const LoadCurve& curve, const SceneLoads& scene, const CriticalLoads& loads) {
    if (loads.scenes.size() == 1) return curve.model;
    return loads.models().size() == 1 ? scene.title : fmt::format("{}, {}", scene.title, curve.model);
}

std::vector<Curve> curves_of(const SceneLoads& scene, const CriticalLoads& loads) {
    std::vector<Curve> curves;
    for (const LoadCurve& curve : scene.curves) {
        const std::string name = name_of(curve, scene, loads);
        curves.push_back(loads.stiffness ? curve_of(name, scene.points, curve.stiffness, 1.0 / kilo)
                                         : curve_of(name, scene.points, curve.loads, 1.0));
    }
    if (loads.along_depth && !loads.stiffness) {
        const double top = ceiling(curves, scene);
        for (Curve& curve : curves) cut(curve, top);
    }
    dot_what_agrees(curves);
    return curves;
}

/// One for all scenes that puncture alike.
std::vector<Curve> puncture_curves(const CriticalLoads& loads) {
    std::vector<Curve> curves;
    if (loads.stiffness || (!loads.along_depth && loads.depth > 0.0)) return curves;
    for (const SceneLoads& scene : loads.scenes) {
        const Curve curve = curve_of("tip punctures", scene.points, scene.puncture, 1.0);
        if (curve.points.empty()) continue;
        const auto alike = std::ranges::find_if(curves, [&](const Curve& other) {
            return other.points.front().y == curve.points.front().y && other.points.back().y == curve.points.back().y;
        });
        if (alike == curves.end()) {
            curves.push_back(curve);
        } else if (curve.points.back().x > alike->points.back().x) {
            *alike = curve;
        }
    }
    return curves;
}

}    // namespace

Figure figure_of(const CriticalLoads& loads) {
    if (loads.one_point())
        throw Failure(ExitCode::wrong_command,
                      "--plot: found one point of each curve, wanted an interval such as --depth 0..50mm");
    Figure figure;
    figure.x_label = with_unit(loads.along_depth ? "Inserted length" : loads.axis, loads.unit);
    figure.y_label = loads.stiffness ? "Foundation stiffness by Eq. (3) (kPa)" : "Critical load (N)";
    const bool one_scene = loads.scenes.size() == 1, one_model = loads.models().size() == 1;
    figure.title = one_scene ? loads.scenes.front().title : one_model ? loads.models().front() : "";
    for (const SceneLoads& scene : loads.scenes) std::ranges::move(curves_of(scene, loads), std::back_inserter(figure.curves));
    drop_shared_beginning(figure.curves);
    std::ranges::move(puncture_curves(loads), std::back_inserter(figure.curves));
    fit_axes(figure);
    for (Curve& curve : figure.curves) {
        if (curve.dotted) space_out(curve, figure);
    }
    return figure;
}

}    // namespace stylet::app
