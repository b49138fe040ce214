#include "apps/study/closed_forms.h"

#include "apps/study/elastica_load.h"
#include "apps/study/loaded_rectangle.h"
#include "core/scene/complaints.h"
#include "core/scene/suggestion.h"

#include <stylet/error.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace stylet::study {
namespace {

/// One question to a formula.
struct Question {
    const char* name;    // of the closed form
    const Measure& measure;
    const core::Scene& scene;
    std::span<const double> x;

    /// Throws Error unless `fits`.
    void want(bool fits, const std::string& found, const std::string& wanted) const {
        if (fits) return;
        throw Error(fmt::format("{}: closed form '{}': found {}, wanted {}", scene.file.string(), name, found, wanted));
    }
};

std::string description(const Measure& measure) {
    struct {
        std::string operator()(const CurveMeasure& m) const { return fmt::format("the curve {} over {}", m.column, m.over); }
        std::string operator()(const ValueMeasure& m) const { return fmt::format("the value {}", m.value); }
        std::string operator()(const EventMeasure& m) const { return fmt::format("{} at the event {}", m.column, m.event); }
        std::string operator()(const AnswerMeasure& m) const { return fmt::format("the critical load at {} mm", 1e3 * m.depth); }
    } describe;
    return std::visit(describe, measure);
}

void want_value(const Question& question, const std::string& value) {
    const auto* measured = std::get_if<ValueMeasure>(&question.measure);
    question.want(measured && measured->value == value, description(question.measure), fmt::format("the value {}", value));
}

void want_curve(const Question& question, const std::vector<std::string>& columns, const std::string& over) {
    const auto* measured = std::get_if<CurveMeasure>(&question.measure);
    question.want(measured && measured->over == over && std::ranges::count(columns, measured->column) == 1,
                  description(question.measure), fmt::format("the curve {} over {}", fmt::join(columns, " or "), over));
}

/// The effects' types in the scene's order.
std::vector<std::string> effects_of(const core::Scene& scene) {
    std::vector<std::string> types;
    for (const core::Choice& effect : scene.effects) types.push_back(effect.type);
    return types;
}

void want_effects(const Question& question, const std::vector<std::string>& allowed, const std::string& wanted) {
    const std::vector<std::string> types = effects_of(question.scene);
    const bool fit = std::ranges::all_of(types, [&](const std::string& type) { return std::ranges::count(allowed, type) == 1; });
    question.want(fit, fmt::format("the effects {}", fmt::join(types, ", ")), wanted);
}

/// The one material that the whole tissue is made of.
const Layer& homogeneous(const Question& question) {
    question.want(question.scene.tissue_setup.has_value(), "no tissue", "a homogeneous one");
    const std::vector<Layer>& layers = question.scene.tissue_setup->layers;
    const Layer& first = layers.front();
    for (const Layer& layer : layers) {
        question.want(layer.youngs_modulus == first.youngs_modulus && layer.poisson_ratio == first.poisson_ratio,
                      fmt::format("the layers {} and {} of two materials", core::quote(first.name), core::quote(layer.name)),
                      "a homogeneous tissue");
    }
    return first;
}

/// The formula's curve at the samples where it has a value (NaN: none).
template <class Formula>
Outcome sampled(std::span<const double> x, const Formula& formula, const char* where) {
    Outcome curve;
    for (const double at : x) {
        const double value = formula(at);
        if (!std::isfinite(value)) continue;
        curve.x.push_back(at);
        curve.y.push_back(value);
    }
    if (curve.x.empty()) curve.missing = fmt::format("holds {}, where there is no sample", where);
    return curve;
}

Outcome elastica(const Question& question) {
    want_curve(question, {"hand_force"}, "travel");
    const core::Scene& scene = question.scene;
    question.want(!scene.tissue, "a tissue", "a needle in air");
    question.want(scene.needle_setup.has_value(), "no needle", "one in air");
    question.want(!scene.effects.empty(), "no effect", "a pin that holds the tip");
    want_effects(question, {"pin"}, "a pin alone");
    question.want(scene.device.has_value(), "no device", "a hand that pushes the needle against the pin");
    const NeedleSetup& needle = *scene.needle_setup;
    const double critical = euler_factor(needle.ends) * needle.bending_stiffness() / (needle.length * needle.length);
    return sampled(
        question.x, [&](double travel) { return critical * elastica_load(needle.ends, travel / needle.length); },
        "from travel 0 to 0.99 of the length");
}

Outcome euler(const Question& question) {
    const core::Scene& scene = question.scene;
    const auto* answer = std::get_if<AnswerMeasure>(&question.measure);
    const auto* value = std::get_if<ValueMeasure>(&question.measure);
    const bool known = (answer && answer->depth == 0.0) || (value && value->value == "critical_load");
    question.want(known, description(question.measure), "the critical load at 0 mm");
    question.want(scene.needle_setup.has_value(), "no needle", "one in air");
    question.want(answer || !scene.tissue, "a tissue", "a needle in air");
    const NeedleSetup& needle = *scene.needle_setup;
    return {.x = {}, .y = {euler_factor(needle.ends) * needle.bending_stiffness() / (needle.length * needle.length)}};
}

/// The force [N] at which the tip punctures the surface; infinite where nothing limits it.
double rupture_force(const core::Scene& scene) {
    double least = std::numeric_limits<double>::infinity();
    const std::string& surface = scene.tissue_setup->layers.front().name;
    for (const core::Choice& effect : scene.effects) {
        const bool there = !effect.parameters.has("layer") || effect.parameters.text("layer") == surface;
        if (effect.type == "fracture" && there) least = std::min(least, effect.parameters.number("rupture_force"));
    }
    return least;
}

bool straight_down(const core::Scene& scene) {
    if (!scene.device || !scene.device->parameters.has("direction")) return true;
    const Vector3 direction = scene.device->parameters.vector3("direction");
    return direction.x() == 0.0 && direction.y() == 0.0 && direction.z() < 0.0;
}

Outcome flat_punch(const Question& question) {
    want_curve(question, {"tip_force", "hand_force"}, "depth");
    const core::Scene& scene = question.scene;
    const Layer& tissue = homogeneous(question);
    question.want(scene.needle_setup.has_value(), "no needle", "one that dents the tissue");
    want_effects(question, {"fracture", "friction"}, "fracture and friction, or none");
    question.want(straight_down(scene), "a hand that pushes aslant", "one that pushes straight down");
    const double effective = tissue.youngs_modulus / (1.0 - tissue.poisson_ratio * tissue.poisson_ratio);    // [Pa] E*
    const double stiffness = 2.0 * scene.needle_setup->radius * effective;                                   // [N/m]
    const double puncture = rupture_force(scene);
    const auto force = [&](double depth) {
        const double at = stiffness * std::max(0.0, depth);
        return at <= puncture ? at : std::numeric_limits<double>::quiet_NaN();
    };
    return sampled(question.x, force, "until the tip punctures");
}

Outcome love(const Question& question) {
    want_value(question, "patch_displacement");
    const core::Scene& scene = question.scene;
    const Layer& tissue = homogeneous(question);
    question.want(!scene.needle, "a needle", "a tissue alone");
    question.want(scene.effects.size() == 1, fmt::format("{} effects", scene.effects.size()), "a patch_load alone");
    want_effects(question, {"patch_load"}, "a patch_load alone");
    const Parameters& load = scene.effects.front().parameters;
    const Vector3 centre = load.vector3("centre"), size = load.vector3("size"), force = load.vector3("force");
    question.want(force.x() == 0.0 && force.y() == 0.0 && force.z() != 0.0,
                  fmt::format("a force of {}, {}, {} N", force.x(), force.y(), force.z()), "one along z");
    const Vector3 reach = centre.cwiseAbs() + 0.5 * size, extent = scene.tissue_setup->extent;
    question.want(size.x() > 0.0 && size.y() > 0.0 && std::abs(centre.z()) <= 0.5 * size.z() && reach.x() <= 0.5 * extent.x() &&
                      reach.y() <= 0.5 * extent.y(),
                  "a patch that is not", "a rectangle whole on the tissue's top");
    const double ramp = load.has("ramp") ? load.number("ramp") : 0.0, duration = scene.run.duration.value_or(0.0);
    question.want(ramp <= duration, fmt::format("a run of {} s", duration),
                  fmt::format("one that outlasts the ramp of {} s", ramp));
    return {.x = {},
            .y = {mean_displacement(size.x(), size.y(), std::abs(force.z()), tissue.youngs_modulus, tissue.poisson_ratio)}};
}

struct Form {
    const char* name;
    const char* title;
    Outcome (*answer)(const Question&);
};

constexpr std::array forms{
    Form{"elastica", "elliptic integrals (closed form)", elastica},
    Form{"euler", "Euler's column (closed form)", euler},
    Form{"flat_punch", "a rigid flat punch on a half-space (closed form)", flat_punch},
    Form{"love", "Love's evenly loaded rectangle on a half-space (closed form)", love},
};

const Form& find(const std::string& name) {
    const auto* const found = std::ranges::find(forms, name, &Form::name);
    if (found != forms.end()) return *found;
    const std::vector<std::string> names = closed_form_names();
    throw Error(fmt::format("found the closed form {}, wanted one of: {}{}", core::quote(name), core::list_of(names),
                            core::suggestion(name, names)));
}

}    // namespace

std::vector<std::string> closed_form_names() {
    std::vector<std::string> names;
    for (const Form& form : forms) names.emplace_back(form.name);
    return names;
}

std::string closed_form_title(const ClosedForm& form) {
    return find(form.name).title;
}

Outcome closed_form(const ClosedForm& form, const Measure& measure, const core::Scene& scene, std::span<const double> x) {
    const Form& known = find(form.name);
    return known.answer({.name = known.name, .measure = measure, .scene = scene, .x = x});
}

}    // namespace stylet::study
