#include "apps/study/closed_forms.h"

#include <stylet/error.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <numbers>

namespace stylet::study {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const Measure hand_force_over_travel = CurveMeasure{.column = "hand_force", .over = "travel"};
const Measure tip_force_over_depth = CurveMeasure{.column = "tip_force", .over = "depth"};
const Measure sinking = ValueMeasure{.value = "patch_displacement"};

core::Choice effect(const std::string& type, Parameters parameters = {}) {
    return {.type = type, .path = "", .place = {}, .parameters = std::move(parameters)};
}

/// As scenes/validation/column_in_air_pinned.yaml says it.
core::Scene column_in_air(Ends ends = Ends::clamped_pinned) {
    core::Scene scene;
    scene.file = "column.yaml";
    scene.needle = effect("rod");
    scene.needle_setup = {.length = 0.2, .radius = 0.3e-3, .youngs_modulus = 200e9, .ends = ends};
    scene.effects = {effect("pin")};
    scene.device = effect("recorded_hand");
    return scene;
}

core::Scene gel() {
    core::Scene scene;
    scene.file = "gel.yaml";
    scene.tissue = effect("half_space");
    const Layer layer{.name = "gel", .youngs_modulus = 25e3, .poisson_ratio = 0.49, .density = std::nan(""), .thickness = 0.15};
    scene.tissue_setup = {.extent = {0.4, 0.4, 0.15}, .fixed = "bottom", .layers = {layer}};
    return scene;
}

/// As scenes/validation/half_space_patch.yaml says it.
core::Scene loaded_gel(const Vector3& force = {0.0, 0.0, -1.0}) {
    core::Scene scene = gel();
    Parameters load;
    load.set("centre", Vector3(0.0, 0.0, 0.0));
    load.set("size", Vector3(0.021, 0.021, 0.0));
    load.set("force", force);
    scene.effects = {effect("patch_load", load)};
    scene.run = {.rate = 1000.0, .duration = 0.1};
    return scene;
}

core::Scene dented_gel() {
    core::Scene scene = gel();
    scene.needle = effect("rigid");
    scene.needle_setup = {.length = 0.1, .radius = 0.3e-3, .youngs_modulus = 200e9, .ends = Ends::clamped_pinned};
    return scene;
}

std::string refusal(const std::string& name, const Measure& measure, const core::Scene& scene) {
    try {
        (void)closed_form({name}, measure, scene, {});
    } catch (const Error& error) {
        return error.what();
    }
    return "accepted";
}

TEST(ClosedForms, AreFoundByName) {
    EXPECT_THAT(closed_form_names(), ElementsAre("elastica", "euler", "flat_punch", "love"));
    EXPECT_EQ(closed_form_title({"elastica"}), "elliptic integrals (closed form)");
    EXPECT_EQ(refusal("elastics", hand_force_over_travel, column_in_air()),
              "found the closed form 'elastics', wanted one of: elastica, euler, flat_punch, love; did you mean 'elastica'?");
}

TEST(ElasticaForm, StartsAtTheCriticalLoadOfTheScenesNeedle) {
    const std::vector<double> travel{0.0, 1e-9, 0.004, 0.0908, 0.199};
    const Outcome curve = closed_form({"elastica"}, hand_force_over_travel, column_in_air(), travel);
    constexpr double printed = 0.5e-4;    // [N] the scene's comment has four digits
    std::printf("a pushed column: %.6f N at once, %.6f N after 4 mm, at most %.6f N\n", curve.y[0], curve.y[1], curve.y[2]);
    ASSERT_THAT(curve.x, ElementsAre(1e-9, 0.004, 0.0908)) << "nothing at travel 0, where any force up to P_cr is right";
    EXPECT_NEAR(curve.y[0], 0.6422, printed);
    EXPECT_NEAR(curve.y[2] / curve.y[0], 1.1396, printed);
    EXPECT_EQ(curve.missing, "");
    const Outcome still = closed_form({"elastica"}, hand_force_over_travel, column_in_air(), std::vector<double>{0.0});
    EXPECT_EQ(still.missing, "holds from travel 0 to 0.99 of the length, where there is no sample");
}

TEST(ElasticaForm, RefusesWhatIsNoPushedColumn) {
    core::Scene scene = column_in_air();
    EXPECT_EQ(refusal("elastica", hand_force_over_travel, scene), "accepted");
    EXPECT_EQ(
        refusal("elastica", tip_force_over_depth, scene),
        "column.yaml: closed form 'elastica': found the curve tip_force over depth, wanted the curve hand_force over travel");
    scene.effects = {effect("pin"), effect("friction")};
    EXPECT_THAT(refusal("elastica", hand_force_over_travel, scene),
                HasSubstr("found the effects pin, friction, wanted a pin alone"));
    scene.effects.clear();
    EXPECT_THAT(refusal("elastica", hand_force_over_travel, scene),
                HasSubstr("found no effect, wanted a pin that holds the tip"));
    scene = column_in_air();
    scene.tissue = effect("half_space");
    EXPECT_THAT(refusal("elastica", hand_force_over_travel, scene), HasSubstr("found a tissue, wanted a needle in air"));
    EXPECT_THAT(refusal("elastica", hand_force_over_travel, gel()), HasSubstr("found a tissue"));
    scene = column_in_air();
    scene.device.reset();
    EXPECT_THAT(refusal("elastica", hand_force_over_travel, scene), HasSubstr("found no device"));
}

TEST(EulerForm, IsTheLoadInAir) {
    const double stiffness = 200e9 * std::numbers::pi * std::pow(0.3e-3, 4) / 4.0;    // [N·m²]
    const Measure answer = AnswerMeasure{.depth = 0.0};
    constexpr double rounding = 1e-15;
    EXPECT_NEAR(closed_form({"euler"}, answer, column_in_air(Ends::pinned_pinned), {}).y.at(0),
                std::pow(std::numbers::pi / 0.2, 2) * stiffness, rounding);
    EXPECT_NEAR(closed_form({"euler"}, ValueMeasure{"critical_load"}, column_in_air(), {}).y.at(0),
                20.190728556 * stiffness / 0.04, 1e-9);
    EXPECT_THAT(refusal("euler", AnswerMeasure{.depth = 0.05}, column_in_air()),
                HasSubstr("found the critical load at 50 mm, wanted the critical load at 0 mm"));
    EXPECT_THAT(refusal("euler", ValueMeasure{"critical_load"}, dented_gel()), HasSubstr("found a tissue"));
    EXPECT_EQ(refusal("euler", answer, dented_gel()), "accepted") << "its tip is at the surface";
    EXPECT_THAT(refusal("euler", answer, gel()), HasSubstr("found no needle"));
}

TEST(FlatPunchForm, IsALineUntilTheTipPunctures) {
    core::Scene scene = dented_gel();
    const std::vector<double> depth{-0.001, 0.0, 0.005, 0.010, 0.011};
    const Outcome endless = closed_form({"flat_punch"}, tip_force_over_depth, scene, depth);
    std::printf("a punch of 0.3 mm on 25 kPa: %.3f N/m, known 19.7\n", endless.y[2] / 0.005);
    EXPECT_THAT(endless.x, testing::ElementsAreArray(depth));
    EXPECT_EQ(endless.y[0], 0.0);
    EXPECT_NEAR(endless.y[2] / 0.005, 19.7, 0.05) << "validation.md has three digits";
    Parameters fracture;
    fracture.set("rupture_force", 0.2);    // at 10.1 mm
    scene.effects = {effect("fracture", fracture)};
    EXPECT_THAT(closed_form({"flat_punch"}, tip_force_over_depth, scene, depth).x, ElementsAre(-0.001, 0.0, 0.005, 0.010));
    fracture.set("layer", std::string("bone"));
    scene.effects = {effect("fracture", fracture)};
    EXPECT_EQ(closed_form({"flat_punch"}, tip_force_over_depth, scene, depth).x.size(), depth.size());
}

TEST(FlatPunchForm, RefusesLayersAndOtherEffects) {
    core::Scene scene = dented_gel();
    scene.effects = {effect("pin")};
    EXPECT_THAT(refusal("flat_punch", tip_force_over_depth, scene),
                HasSubstr("found the effects pin, wanted fracture and friction"));
    scene = dented_gel();
    Layer stiff = scene.tissue_setup->layers.front();
    stiff.name = "skin";
    scene.tissue_setup->layers.push_back(stiff);
    EXPECT_EQ(refusal("flat_punch", tip_force_over_depth, scene), "accepted") << "one material by two names";
    scene.tissue_setup->layers.back().youngs_modulus *= 2.0;
    EXPECT_THAT(refusal("flat_punch", tip_force_over_depth, scene),
                HasSubstr("found the layers 'gel' and 'skin' of two materials"));
    EXPECT_THAT(refusal("flat_punch", hand_force_over_travel, dented_gel()),
                HasSubstr("wanted the curve tip_force or hand_force over depth"));
    EXPECT_THAT(refusal("flat_punch", tip_force_over_depth, gel()), HasSubstr("found no needle"));
    EXPECT_THAT(refusal("flat_punch", tip_force_over_depth, column_in_air()), HasSubstr("found no tissue"));
    scene = dented_gel();
    scene.device = effect("recorded_hand");
    scene.device->parameters.set("direction", Vector3(1.0, 0.0, -1.0));
    EXPECT_THAT(refusal("flat_punch", tip_force_over_depth, scene), HasSubstr("found a hand that pushes aslant"));
}

TEST(LoveForm, IsTheMeanUnderASquare) {
    const double sunk = closed_form({"love"}, sinking, loaded_gel(), {}).y.at(0);
    std::printf("1 N on 21 mm by 21 mm: %.4f mm, known 1.3698\n", 1e3 * sunk);
    constexpr double printed = 0.5e-7;    // [m] the scene's comment has four digits after the millimetre
    EXPECT_NEAR(sunk, 1.3698e-3, printed);
}

TEST(LoveForm, RefusesWhatItsRectangleIsNot) {
    EXPECT_THAT(refusal("love", sinking, loaded_gel({1.0, 0.0, -1.0})),
                HasSubstr("found a force of 1, 0, -1 N, wanted one along z"));
    EXPECT_THAT(refusal("love", ValueMeasure{"peak_hand_force"}, loaded_gel()), HasSubstr("wanted the value patch_displacement"));
    EXPECT_THAT(refusal("love", sinking, gel()), HasSubstr("found 0 effects"));
    core::Scene scene = loaded_gel();
    scene.effects.front().parameters.set("centre", Vector3(0.195, 0.0, 0.0));
    EXPECT_THAT(refusal("love", sinking, scene), HasSubstr("wanted a rectangle whole on the tissue's top"));
    scene = loaded_gel();
    scene.effects.front().parameters.set("ramp", 0.5);
    EXPECT_THAT(refusal("love", sinking, scene), HasSubstr("found a run of 0.1 s, wanted one that outlasts the ramp of 0.5 s"));
    scene = loaded_gel();
    scene.needle = effect("rigid");
    EXPECT_THAT(refusal("love", sinking, scene), HasSubstr("found a needle, wanted a tissue alone"));
}

}    // namespace
}    // namespace stylet::study
