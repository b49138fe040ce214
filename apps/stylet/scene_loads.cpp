#include "apps/stylet/scene_loads.h"

#include "apps/stylet/column_at_depth.h"
#include "apps/stylet/gathered_errors.h"
#include "apps/stylet/puncture_force.h"
#include "core/loading/loaded.h"
#include "core/scene/units.h"

#include <fmt/format.h>

#include <cmath>
#include <numeric>

namespace stylet::app {
namespace {

double load_of(core::Loaded<BucklingModel>& model, const Column& column) {
    return model.ask([&](const BucklingModel& buckling) {
        const double load = buckling.critical_load(column);
        if (std::isnan(load)) throw Error(fmt::format("answered no number for {:g} m of needle in air", column.free_length));
        return load;
    });
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
        const core::Scene scene = read(varies ? varied(question_.varied->values.from) : std::vector<core::Override>{});
        models_ = question_.models.empty() ? models_of(scene) : question_.models;
        if (models_.empty()) refuse("found a needle without 'buckling', wanted one, or a model named by --model NAME");
        loads_ = {.file = file_,
                  .title = scene.title,
                  .hash = scene.hash,
                  .needle = *scene.needle_setup,
                  .gauge = scene.gauge,
                  .has_tissue = scene.tissue.has_value(),
                  .points = {},
                  .puncture = {},
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
        return {{key.key, key.values.quantity(value), "--vary " + key.key}};
    }

    [[nodiscard]] Column column(const core::Scene& scene, const Interval& depth, double point) const {
        return column_at_depth(scene, core::read_quantity(depth.quantity(point), "m").value, depth.text);
    }

    void add_load(const core::Scene& scene, core::Loaded<BucklingModel>& model, const Column& column, LoadCurve& curve) const {
        curve.loads.push_back(load_of(model, column));
        if (question_.stiffness) curve.stiffness.push_back(equivalent_stiffness(scene, column, curve.loads.back()));
    }

    /// `difference` of load and puncture force anywhere on the axis.
    template <class Difference>
    void find_crossings(LoadCurve& curve, Difference&& difference) const {
        const auto less = [&](std::size_t i) { return curve.loads[i] < loads_.puncture[i]; };
        for (std::size_t i = 1; i < loads_.points.size(); ++i) {
            if (!std::isfinite(loads_.puncture[i]) || less(i - 1) == less(i)) continue;
            curve.crossings.push_back(crossing(loads_.points[i - 1], loads_.points[i], difference));
        }
    }

    /// The scene stays what it is: each model is made once.
    void along_depth(const core::Scene& scene) {
        constexpr double mm = 1e-3;    // [m]
        const Interval depth = question_.depth.value_or(Interval{0.0, deepest(scene) / mm, "mm", ""});
        loads_.points = depth.values(question_.points);
        GatheredErrors errors;
        errors.gather([&] {
            for (const double end : {loads_.points.front(), loads_.points.back()}) (void)column(scene, depth, end);
        });
        errors.gather([&] { loads_.puncture.assign(loads_.points.size(), puncture_force(scene, question_.folders)); });
        for (std::size_t m = 0; m < models_.size(); ++m) {
            errors.gather([&] {
                const core::Scene with = read({}, models_[m].overrides);
                core::Loaded<BucklingModel> model(with, *with.buckling, question_.folders);
                LoadCurve& curve = loads_.curves[m];
                curve.at_surface = load_of(model, column_at_depth(with, 0.0, ""));
                for (const double point : loads_.points) add_load(with, model, column(with, depth, point), curve);
                if (loads_.puncture.empty()) return;    // which is complained of
                find_crossings(
                    curve, [&](double point) { return load_of(model, column(with, depth, point)) - loads_.puncture.front(); });
            });
        }
        errors.throw_if_any();
    }

    /// Each point is another scene.
    void along_key() {
        loads_.points = question_.varied->values.values(question_.points);
        for (const double point : loads_.points) {
            GatheredErrors errors;
            errors.gather([&] { loads_.puncture.push_back(puncture_at(point)); });
            for (std::size_t m = 0; m < models_.size(); ++m)
                errors.gather([&] { add_load_at(point, models_[m], loads_.curves[m]); });
            errors.throw_if_any();    // the next point would say the same again
        }
        for (std::size_t m = 0; m < models_.size(); ++m) {
            find_crossings(loads_.curves[m], [&](double point) {
                LoadCurve there;
                add_load_at(point, models_[m], there);
                return there.loads.front() - puncture_at(point);
            });
        }
    }

    [[nodiscard]] double puncture_at(double point) const { return puncture_force(read(varied(point)), question_.folders); }

    void add_load_at(double point, const AskedModel& asked, LoadCurve& curve) const {
        const core::Scene with = read(varied(point), asked.overrides);
        core::Loaded<BucklingModel> model(with, *with.buckling, question_.folders);
        const Interval depth = question_.depth.value_or(Interval{0.0, 0.0, "mm", ""});
        add_load(with, model, column(with, depth, depth.from), curve);
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
