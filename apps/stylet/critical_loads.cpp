#include "apps/stylet/critical_loads.h"

#include "apps/stylet/gathered_errors.h"
#include "apps/stylet/puncture_force.h"
#include "core/loading/loaded.h"
#include "core/scene/complaints.h"
#include "core/scene/units.h"

#include <stylet/buckling_model.h>
#include <stylet/foundation_equation.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace stylet::app {
namespace {

constexpr double rounding = 1e-9;    // of a length: sums and units written in decimals

double in_metres(const Interval& depth, double value) {
    return core::read_quantity(depth.quantity(value), "m").value;
}

[[noreturn]] void refuse(const std::string& file, const std::string& sentence) {
    throw core::SceneErrors({fmt::format("{}: {}", file, sentence)});
}

double deepest(const core::Scene& scene) {    // [m]
    if (!scene.tissue_setup) return 0.0;
    return std::min(scene.needle_setup->length, scene.tissue_setup->extent.z());
}

/// Of a needle that goes in at a right angle.
Column column_of(const NeedleSetup& needle, double depth) {
    const double inserted = std::min(depth, needle.length);
    return {.bending_stiffness = needle.bending_stiffness(),
            .free_length = needle.length - inserted,
            .inserted = inserted,
            .depth = inserted,
            .radius = needle.radius,
            .ends = needle.ends};
}

double load_of(core::Loaded<BucklingModel>& model, const Column& column) {
    return model.ask([&](const BucklingModel& buckling) {
        const double load = buckling.critical_load(column);
        if (std::isnan(load)) throw Error(fmt::format("answered no number for {:g} m of needle in air", column.free_length));
        return load;
    });
}

/// Eq. (3) of the paper, in the form that its tables were calculated with.
double stiffness_of(const Column& column, double load) {
    return foundation_stiffness(column.bending_stiffness, column.length(), load, FoundationForm::consistent);
}

/// One scene's share of a question.
class Asking {
public:
    Asking(const LoadQuestion& question, const std::string& file) : question_(question), file_(file) {}

    SceneLoads answer() {
        const bool varies = question_.varied.has_value();
        core::Scene scene = read(varies ? varied(question_.varied->values.from) : std::vector<core::Override>{});
        expect_needle(scene);
        models_ = question_.models.empty() ? models_of(scene) : question_.models;
        if (models_.empty()) refuse(file_, "found a needle without 'buckling', wanted one, or a model named by --model NAME");
        loads_ = {.file = file_,
                  .title = scene.title,
                  .hash = scene.hash,
                  .needle = *scene.needle_setup,
                  .gauge = scene.gauge,
                  .has_tissue = scene.tissue.has_value(),
                  .points = {},
                  .puncture = {},
                  .curves = {}};
        for (const AskedModel& model : models_)
            loads_.curves.push_back({.model = model.label(), .loads = {}, .stiffness = {}, .at_surface = {}});
        if (varies) {
            along_key();
        } else {
            along_depth(scene);
        }
        return std::move(loads_);
    }

private:
    [[nodiscard]] core::Scene read(const std::vector<core::Override>& more) const {
        std::vector<core::Override> overrides = question_.overrides;
        overrides.insert(overrides.end(), more.begin(), more.end());
        return core::read_scene(file_, overrides, question_.folders);
    }

    [[nodiscard]] std::vector<core::Override> varied(double value) const {
        const VariedKey& key = *question_.varied;
        return {{key.key, key.values.quantity(value), "--vary " + key.key}};
    }

    void expect_needle(const core::Scene& scene) const {
        if (!scene.needle) refuse(file_, "found a scene without a needle, wanted one: only a needle buckles");
    }

    /// [m] Throws where the scene's needle cannot be so deep.
    [[nodiscard]] double checked_depth(double depth, const core::Scene& scene) const {
        const double most = deepest(scene);
        if (depth >= 0.0 && depth <= most * (1.0 + rounding)) return std::min(depth, most);
        const char* const why = !scene.tissue                       ? "the scene has no tissue"
                                : most < scene.needle_setup->length ? "the tissue's height"
                                                                    : "the needle's length";
        refuse(file_, fmt::format("--depth: found {}, wanted {} ({})", core::quote(question_.depth->text),
                                  most > 0.0 ? fmt::format("0 m to {:g} m", most) : "0 m", why));
    }

    void expect_formula(const Column& column) const {
        if (column.ends != Ends::clamped_free)
            refuse(file_, "--stiffness: found other ends than clamped-free, wanted those: Eq. (3) is of such a column");
        if (column.free_length > rounding * column.length()) {
            refuse(file_, fmt::format("--stiffness: found {:g} m of needle in air, wanted a needle wholly in tissue "
                                      "(--depth '{:g} mm'): Eq. (3) knows no air",
                                      column.free_length, 1e3 * column.length()));
        }
    }

    void add_load(core::Loaded<BucklingModel>& model, const Column& column, LoadCurve& curve) const {
        if (question_.stiffness) expect_formula(column);
        curve.loads.push_back(load_of(model, column));
        if (question_.stiffness) curve.stiffness.push_back(stiffness_of(column, curve.loads.back()));
    }

    /// The scene stays what it is: each model is made once.
    void along_depth(const core::Scene& scene) {
        constexpr double mm = 1e-3;    // [m]
        const Interval depth = question_.depth.value_or(Interval{0.0, deepest(scene) / mm, "mm", ""});
        loads_.points = depth.values(question_.points);
        std::vector<Column> columns;
        GatheredErrors errors;
        errors.gather([&] {
            for (const double point : loads_.points)
                columns.push_back(column_of(*scene.needle_setup, checked_depth(in_metres(depth, point), scene)));
        });
        errors.gather([&] { loads_.puncture.assign(loads_.points.size(), puncture_force(scene, question_.folders)); });
        for (std::size_t m = 0; m < models_.size(); ++m) {
            errors.gather([&] {
                const core::Scene with = read(models_[m].overrides);
                core::Loaded<BucklingModel> model(with, *with.buckling, question_.folders);
                LoadCurve& curve = loads_.curves[m];
                curve.at_surface = load_of(model, column_of(*with.needle_setup, 0.0));
                for (const Column& column : columns) add_load(model, column, curve);
            });
        }
        errors.throw_if_any();
    }

    /// Each point is another scene.
    void along_key() {
        loads_.points = question_.varied->values.values(question_.points);
        for (const double point : loads_.points) {
            GatheredErrors errors;
            errors.gather([&] {
                const core::Scene scene = read(varied(point));
                expect_needle(scene);
                loads_.puncture.push_back(puncture_force(scene, question_.folders));
            });
            for (std::size_t m = 0; m < models_.size(); ++m) {
                errors.gather([&] {
                    std::vector<core::Override> overrides = varied(point);
                    overrides.insert(overrides.end(), models_[m].overrides.begin(), models_[m].overrides.end());
                    const core::Scene with = read(overrides);
                    const double depth = question_.depth ? in_metres(*question_.depth, question_.depth->from) : 0.0;
                    core::Loaded<BucklingModel> model(with, *with.buckling, question_.folders);
                    add_load(model, column_of(*with.needle_setup, checked_depth(depth, with)), loads_.curves[m]);
                });
            }
            errors.throw_if_any();    // the next point would say the same again
        }
    }

    const LoadQuestion& question_;
    const std::string& file_;
    std::vector<AskedModel> models_;
    SceneLoads loads_{};
};

}    // namespace

const LoadCurve* SceneLoads::curve(const std::string& model) const {
    const auto found = std::ranges::find(curves, model, &LoadCurve::model);
    return found == curves.end() ? nullptr : &*found;
}

std::vector<std::string> CriticalLoads::models() const {
    std::vector<std::string> models;
    for (const SceneLoads& scene : scenes) {
        for (const LoadCurve& curve : scene.curves) {
            if (std::ranges::find(models, curve.model) == models.end()) models.push_back(curve.model);
        }
    }
    return models;
}

bool CriticalLoads::one_point() const {
    return std::ranges::all_of(scenes, [](const SceneLoads& scene) { return scene.points.size() == 1; });
}

CriticalLoads critical_loads(const LoadQuestion& question) {
    CriticalLoads loads{.axis = "depth", .unit = "mm", .along_depth = !question.varied, .scenes = {}};
    if (question.varied) {
        loads.axis = question.varied->key;
        loads.unit = question.varied->values.unit;
        if (question.depth) loads.depth = in_metres(*question.depth, question.depth->from);
    } else if (question.depth) {
        loads.unit = question.depth->unit;
    }
    GatheredErrors errors;
    for (const std::string& file : question.scenes)
        errors.gather([&] { loads.scenes.push_back(Asking(question, file).answer()); });
    errors.throw_if_any();
    return loads;
}

}    // namespace stylet::app
