#include "apps/stylet/scene_loads.h"

#include "apps/study/gathered_errors.h"
#include "apps/study/inserted_column.h"
#include "apps/stylet/column_at_depth.h"
#include "apps/stylet/insertion_force.h"
#include "core/loading/loaded.h"
#include "core/scene/units.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace stylet::app {
namespace {

double answer_of(core::Loaded<BucklingModel>& model, const Column& column) {
    return model.ask([&](const BucklingModel& buckling) {
        const double load = buckling.critical_load(column);
        if (std::isnan(load)) throw Error(fmt::format("answered no number for {:g} m of needle in air", column.free_length));
        return load;
    });
}

/// NaN where no needle is left in air and the model, to which what is inserted is all one, knows nothing else: a load of nothing.
double load_of(core::Loaded<BucklingModel>& model, const Column& column) {
    const double load = answer_of(model, column);
    if (column.free_length >= column.radius) return load;
    Column in_air = column;
    in_air.inserted = in_air.depth = 0.0;
    return answer_of(model, in_air) == load ? std::numeric_limits<double>::quiet_NaN() : load;
}

/// Where `difference` changes its sign between two places that it does at, to a millionth of the way between them.
template <class Difference>
double crossing(double before, double after, Difference&& difference) {
    constexpr int halvings = 20;
    const bool negative = difference(before) < 0.0;
    for (int i = 0; i < halvings; ++i) {
        const double middle = std::midpoint(before, after);
        ((difference(middle) < 0.0) == negative ? before : after) = middle;
    }
    return after;
}

/// One scene's share of a question.
class Asking {
public:
    Asking(const LoadQuestion& question, const std::string& file) : question_(question), file_(file) {}

    SceneLoads answer() {
        const bool varies = question_.varied.has_value();
        const core::Scene scene = varies ? read(varied(question_.varied->values.from), first_model()) : read({});
        models_ = question_.models.empty() ? models_of(scene) : question_.models;
        for (AskedModel& model : models_) {
            if (scene.buckling && model.type == scene.buckling->type && model.changes.empty()) model.overrides.clear();
        }
        if (models_.empty()) refuse("found a needle without 'buckling', wanted one, or a model named by --model NAME");
        loads_ = {.file = file_,
                  .name = "",
                  .title = scene.title,
                  .hash = scene.hash,
                  .needle = *scene.needle_setup,
                  .gauge = scene.gauge,
                  .needle_type = scene.needle->type,
                  .has_buckling = scene.buckling.has_value(),
                  .has_tissue = scene.tissue.has_value(),
                  .points = {},
                  .puncture = {},
                  .insertion = {},
                  .curves = {}};
        for (const AskedModel& model : models_) loads_.curves.push_back({.model = model.label()});
        if (varies) {
            along_key();
        } else {
            along_depth(scene);
        }
        return std::move(loads_);
    }

private:
    [[noreturn]] void refuse(const std::string& sentence) const {
        throw core::SceneErrors({fmt::format("{}: {}", file_, sentence)});
    }

    [[nodiscard]] core::Scene read(const std::vector<core::Override>& more,
                                   const std::vector<core::Override>& of_model = {}) const {
        std::vector<core::Override> overrides = question_.overrides;
        overrides.insert(overrides.end(), more.begin(), more.end());
        overrides.insert(overrides.end(), of_model.begin(), of_model.end());
        core::Scene scene = core::read_scene(file_, overrides, question_.folders);
        if (!scene.needle) refuse("found a scene without a needle, wanted one: only a needle buckles");
        return scene;
    }

    [[nodiscard]] std::vector<core::Override> varied(double value) const {
        const VariedKey& key = *question_.varied;
        return {{key.key, key.values.quantity(value), "--vary " + key.key, of_a_model(key)}};
    }

    /// A model that --model names may have no map in the scene yet.
    [[nodiscard]] bool of_a_model(const VariedKey& key) const {
        return !question_.models.empty() && key.key.starts_with("needle.buckling.");
    }

    /// A key within needle.buckling has its place only once a model is there.
    [[nodiscard]] std::vector<core::Override> first_model() const {
        return of_a_model(*question_.varied) ? question_.models.front().overrides : std::vector<core::Override>{};
    }

    /// Where the next scene of a key that goes in whole numbers could be.
    [[nodiscard]] std::string hint(double point) const {
        const study::Interval& values = question_.varied->values;
        const auto whole = [](double value) { return value == std::floor(value); };
        if (!values.unit.empty() || !whole(values.from) || !whole(values.to) || whole(point)) return "";
        return fmt::format("; --points {:.0f} goes from {:.0f} to {:.0f} in whole numbers", values.to - values.from + 1.0,
                           values.from, values.to);
    }

    [[nodiscard]] Column column(const core::Scene& scene, const study::Interval& depth, double point) const {
        return column_at_depth(scene, core::read_quantity(depth.quantity(point), "m").value, depth.text);
    }

    void add_load(const core::Scene& scene, core::Loaded<BucklingModel>& model, const Column& column, LoadCurve& curve) const {
        curve.loads.push_back(load_of(model, column));
        if (question_.stiffness) curve.stiffness.push_back(equivalent_stiffness(scene, column, curve.loads.back()));
    }

    /// Where the load changes sides with `forces`, which the needle has to bear; their `difference` anywhere on the axis.
    template <class Difference>
    [[nodiscard]] std::vector<double> crossings(const LoadCurve& curve, const std::vector<double>& forces,
                                                Difference&& difference) const {
        const auto compares = [&](std::size_t i) { return !std::isnan(curve.loads[i]) && std::isfinite(forces[i]); };
        const auto less = [&](std::size_t i) { return curve.loads[i] < forces[i]; };
        std::vector<double> found;
        for (std::size_t i = 1; i < loads_.points.size(); ++i) {
            if (compares(i - 1) && compares(i) && less(i - 1) != less(i))
                found.push_back(crossing(loads_.points[i - 1], loads_.points[i], difference));
        }
        return found;
    }

    /// Evenly spaced, and the borders of the layers between them: there the load has its kinks.
    [[nodiscard]] std::vector<double> depth_points(const core::Scene& scene, const study::Interval& depth) const {
        std::vector<double> points = depth.values(question_.points);
        if (depth.one_value() || !scene.tissue_setup) return points;
        const core::Quantity unit = core::read_quantity(depth.quantity(1.0), "m");    // [m] of one on the axis
        double border = 0.0;                                                          // [m]
        for (const Layer& layer : scene.tissue_setup->layers) {
            border += layer.thickness;
            const double point = study::rounded(border / unit.value);
            const auto next = std::ranges::lower_bound(points, point);
            if (next != points.begin() && next != points.end() && *next != point) points.insert(next, point);
        }
        return points;
    }

    /// The scene stays what it is: each model and each effect is made once.
    void along_depth(const core::Scene& scene) {
        constexpr double mm = 1e-3;    // [m]
        const study::Interval depth = question_.depth.value_or(study::Interval{0.0, study::deepest(scene) / mm, "mm", ""});
        loads_.points = depth_points(scene, depth);
        study::GatheredErrors errors;
        errors.gather([&] {
            for (const double end : {loads_.points.front(), loads_.points.back()}) (void)column(scene, depth, end);
        });
        std::optional<InsertionForce> force;
        errors.gather([&] {
            force.emplace(scene, question_.folders);
            loads_.puncture.assign(loads_.points.size(), force->puncture());
            for (const double point : loads_.points)
                loads_.insertion.push_back(force->inside(column(scene, depth, point).inserted));
        });
        for (std::size_t m = 0; m < models_.size(); ++m)
            errors.gather([&] { ask_along_depth(models_[m], depth, force, loads_.curves[m]); });
        errors.throw_if_any();
    }

    void ask_along_depth(const AskedModel& asked, const study::Interval& depth, std::optional<InsertionForce>& force,
                         LoadCurve& curve) const {
        const core::Scene with = read({}, asked.overrides);
        core::Loaded<BucklingModel> model(with, *with.buckling, question_.folders);
        curve.at_surface = load_of(model, column_at_depth(with, 0.0, ""));
        for (const double point : loads_.points) add_load(with, model, column(with, depth, point), curve);
        if (!force) return;    // which is complained of
        const auto load_at = [&](double point) { return load_of(model, column(with, depth, point)); };
        curve.crossings =
            crossings(curve, loads_.puncture, [&](double point) { return load_at(point) - loads_.puncture.front(); });
        curve.inside_crossings = crossings(curve, loads_.insertion, [&](double point) {
            return load_at(point) - force->inside(column(with, depth, point).inserted);
        });
    }

    /// Each point is another scene.
    void along_key() {
        loads_.points = question_.varied->values.values(question_.points);
        for (const double point : loads_.points) {
            study::GatheredErrors errors;
            errors.gather([&] { add_forces_at(point, loads_.puncture, loads_.insertion); });
            for (std::size_t m = 0; m < models_.size(); ++m)
                errors.gather([&] { add_load_at(point, models_[m], loads_.curves[m]); });
            errors.throw_if_any(hint(point));    // the next point would say the same again
        }
        for (std::size_t m = 0; m < models_.size(); ++m) {
            LoadCurve& curve = loads_.curves[m];
            const auto less_force = [&](bool inside) {
                return [this, inside, m](double point) {
                    LoadCurve there;
                    add_load_at(point, models_[m], there);
                    std::vector<double> puncture, insertion;
                    add_forces_at(point, puncture, insertion);
                    return there.loads.front() - (inside ? insertion : puncture).front();
                };
            };
            curve.crossings = crossings(curve, loads_.puncture, less_force(false));
            curve.inside_crossings = crossings(curve, loads_.insertion, less_force(true));
        }
    }

    [[nodiscard]] study::Interval one_depth() const { return question_.depth.value_or(study::Interval{0.0, 0.0, "mm", ""}); }

    void add_forces_at(double point, std::vector<double>& puncture, std::vector<double>& insertion) const {
        const core::Scene scene = read(varied(point), first_model());
        InsertionForce force(scene, question_.folders);
        puncture.push_back(force.puncture());
        insertion.push_back(force.inside(column(scene, one_depth(), one_depth().from).inserted));
    }

    void add_load_at(double point, const AskedModel& asked, LoadCurve& curve) const {
        const core::Scene with = read(varied(point), asked.overrides);
        core::Loaded<BucklingModel> model(with, *with.buckling, question_.folders);
        add_load(with, model, column(with, one_depth(), one_depth().from), curve);
    }

    const LoadQuestion& question_;
    const std::string& file_;
    std::vector<AskedModel> models_;
    SceneLoads loads_{};
};

}    // namespace

SceneLoads scene_loads(const LoadQuestion& question, const std::string& file) {
    return Asking(question, file).answer();
}

}    // namespace stylet::app
