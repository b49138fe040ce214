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

/// The curves of one scene, one for each of its models.
struct SceneCurves {
    const SceneLoads* scene;
    std::vector<Curve> curves;
};

/// The load of what little is in air at last has no bound: a picture of an insertion ends at some multiples of what is usual.
double ceiling(const std::vector<SceneCurves>& scenes) {
    constexpr double multiples = 3.0, above_puncture = 1.5;
    std::vector<double> all;
    double puncture = 0.0;
    for (const auto& [scene, curves] : scenes) {
        for (const Curve& curve : curves) {
            for (const Point& point : curve.points) all.push_back(point.y);
        }
        // Of one scene this is drawn as well, and what the load crosses should be seen.
        for (const double force : scenes.size() == 1 ? scene->insertion : std::vector<double>{}) {
            if (std::isfinite(force)) puncture = std::max(puncture, force);
        }
        if (std::isfinite(scene->puncture.front())) puncture = std::max(puncture, scene->puncture.front());
    }
    if (all.empty()) return puncture;
    const auto middle = all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2);
    std::nth_element(all.begin(), middle, all.end());
    return std::max(multiples * *middle, above_puncture * puncture);
}

/// Leaves of the curve what comes first below `top`, ended where it crosses it.
void cut(Curve& curve, double top) {
    const auto crossing = [top](const Point& one, const Point& other) {
        return Point{std::lerp(one.x, other.x, (top - one.y) / (other.y - one.y)), top};
    };
    std::vector<Point>& points = curve.points;
    const auto below = std::ranges::find_if(points, [top](const Point& point) { return point.y <= top; });
    if (below == points.end()) return;    // a picture of it alone
    if (below != points.begin()) {
        *(below - 1) = crossing(*(below - 1), *below);
        points.erase(points.begin(), below - 1);
    }
    const auto over = std::ranges::find_if(points, [top](const Point& point) { return point.y > top; });
    if (over == points.end()) return;
    *over = crossing(*(over - 1), *over);
    points.erase(over + 1, points.end());
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
        const bool far = kept.empty() || std::hypot(figure.x.share(point.x) - figure.x.share(kept.back().x),
                                                    figure.y.share(point.y) - figure.y.share(kept.back().y)) > apart;
        if (far) kept.push_back(point);
    }
    curve.points = std::move(kept);
}

/// A model looks alike in all scenes: dotted where it agrees in each of them with one that is drawn as a line.
void dot_what_agrees(std::vector<SceneCurves>& scenes, const std::vector<std::string>& models) {
    double height = 0.0;
    for (const SceneCurves& scene : scenes) {
        for (const Curve& curve : scene.curves) height = std::max(height, greatest(curve));
    }
    const auto curve_of_model = [](SceneCurves& scene, const std::string& model) -> Curve* {
        const auto found = std::ranges::find(scene.scene->curves, model, &LoadCurve::model);
        return found == scene.scene->curves.end() ? nullptr
                                                  : &scene.curves[static_cast<std::size_t>(found - scene.scene->curves.begin())];
    };
    const auto agree_everywhere = [&](const std::string& one, const std::string& other) {
        return std::ranges::all_of(scenes, [&](SceneCurves& scene) {
            const Curve *const first = curve_of_model(scene, one), *const second = curve_of_model(scene, other);
            return first != nullptr && second != nullptr && agree(*first, *second, height);
        });
    };
    std::vector<std::string> lines;
    for (const std::string& model : models) {
        if (std::ranges::none_of(lines, [&](const std::string& line) { return agree_everywhere(line, model); })) {
            lines.push_back(model);
            continue;
        }
        for (SceneCurves& scene : scenes) curve_of_model(scene, model)->look = Look::dots;
    }
}

/// What tells this curve from the others: its model, its scene, or both.
std::string name_of(const LoadCurve& curve, const SceneLoads& scene, const CriticalLoads& loads) {
    if (loads.scenes.size() == 1) return curve.model;
    return loads.models().size() == 1 ? scene.title : fmt::format("{}, {}", scene.title, curve.model);
}

std::vector<Curve> load_curves(const CriticalLoads& loads) {
    std::vector<SceneCurves> scenes;
    for (const SceneLoads& scene : loads.scenes) {
        SceneCurves& drawn = scenes.emplace_back(SceneCurves{&scene, {}});
        for (const LoadCurve& curve : scene.curves) {
            const std::string name = name_of(curve, scene, loads);
            drawn.curves.push_back(loads.stiffness ? curve_of(name, scene.points, curve.stiffness, 1.0 / kilo)
                                                   : curve_of(name, scene.points, curve.loads, 1.0));
        }
    }
    if (loads.along_depth && !loads.stiffness) {
        const double top = ceiling(scenes);
        for (SceneCurves& scene : scenes) {
            for (Curve& curve : scene.curves) cut(curve, top);
        }
    }
    dot_what_agrees(scenes, loads.models());
    std::vector<Curve> curves;
    for (SceneCurves& scene : scenes) std::ranges::move(scene.curves, std::back_inserter(curves));
    for (Curve& curve : curves) {
        if (curve.points.size() == 1) curve.look = Look::dots;    // a line of one point is nothing
    }
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

/// What the needle has to bear inside; of one scene, for each has its own.
std::vector<Curve> insertion_curve(const CriticalLoads& loads) {
    const bool inside = loads.along_depth || loads.depth > 0.0;
    if (loads.stiffness || !inside || loads.scenes.size() > 1) return {};
    const SceneLoads& scene = loads.scenes.front();
    const Curve curve = curve_of("cutting and friction", scene.points, scene.insertion, 1.0);
    return curve.points.empty() ? std::vector<Curve>{} : std::vector<Curve>{curve};
}

}    // namespace

Figure figure_of(const CriticalLoads& loads) {
    if (loads.one_point())
        throw Failure(ExitCode::wrong_command,
                      "--plot: found one point of each curve, wanted an interval such as --depth 0..50mm");
    Figure figure;
    figure.x.label = with_unit(loads.along_depth ? "Inserted length" : loads.axis, loads.unit);
    figure.y.label = loads.stiffness ? "Foundation stiffness by Eq. (3) (kPa)" : "Critical load (N)";
    const bool one_scene = loads.scenes.size() == 1, one_model = loads.models().size() == 1;
    figure.title = one_scene ? loads.scenes.front().title : one_model ? loads.models().front() : "";
    figure.curves = load_curves(loads);
    drop_shared_beginning(figure.curves);
    std::ranges::move(puncture_curves(loads), std::back_inserter(figure.curves));
    std::ranges::move(insertion_curve(loads), std::back_inserter(figure.curves));
    // A curve alone has no key to say what it is.
    if (figure.curves.size() == 1 && one_scene) figure.title += ", " + loads.models().front();
    if (!loads.along_depth && loads.depth > 0.0)
        figure.title += fmt::format("{}{:.4g} mm inserted", figure.title.empty() ? "" : ", ", kilo * loads.depth);
    fit_axes(figure);
    for (Curve& curve : figure.curves) {
        if (curve.look == Look::dots) space_out(curve, figure);
    }
    return figure;
}

}    // namespace stylet::app
