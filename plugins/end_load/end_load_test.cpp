#include <stylet/contract/contract.h>

namespace stylet {
namespace {

using contract::Case;

const contract::Given step{{"force", Vector3(0.0, 0.1, 0.7)}};
const contract::Given slow{{"force", Vector3(0.0, 0.1, 0.7)}, {"ramp", 2.0}};

STYLET_CONTRACT(Case{.name = "Step", .parameters = step, .has_tissue = false},
                Case{.name = "Ramp", .parameters = slow, .has_tissue = false})

constexpr double rounding = 1e-15;    // [N] of a force below one: one multiplication

Vector3 own_force(const contract::Given& parameters, const Contact& contact) {
    const Case scene{.parameters = parameters, .has_tissue = false};
    ContactLaw law;
    contract::make<ForceModel>(STYLET_PLUGIN_FILE, scene)->add_to(contact, law);
    EXPECT_FALSE(law.tip_limited);
    EXPECT_FALSE(law.held);
    return law.own_force;
}

Contact tip_in_air(double time) {
    return {.tip = true,
            .inside = false,
            .layer = -1,
            .coverage = 0.0,
            .axial_force = 0.0,
            .slip = 0.0,
            .slipping = false,
            .needle_radius = 0.3e-3,
            .axis = Vector3(0.0, 0.0, -1.0),
            .time = time};
}

TEST(EndLoad, PushesTheTipFromTheFirstInstantOn) {
    EXPECT_EQ(own_force(step, tip_in_air(-1.0)), Vector3::Zero());
    EXPECT_EQ(own_force(step, tip_in_air(0.0)), Vector3::Zero());
    EXPECT_EQ(own_force(step, tip_in_air(1e-9)), Vector3(0.0, 0.1, 0.7));
}

TEST(EndLoad, GrowsLinearlyOverItsRamp) {
    EXPECT_EQ(own_force(slow, tip_in_air(0.0)), Vector3::Zero());
    EXPECT_LE((own_force(slow, tip_in_air(0.5)) - Vector3(0.0, 0.025, 0.175)).norm(), rounding);
    EXPECT_EQ(own_force(slow, tip_in_air(2.5)), Vector3(0.0, 0.1, 0.7));
}

TEST(EndLoad, AddsToWhatOtherEffectsPushWith) {
    const Case scene{.parameters = step, .has_tissue = false};
    ContactLaw law;
    law.own_force = Vector3(1.0, 0.0, 0.0);
    contract::make<ForceModel>(STYLET_PLUGIN_FILE, scene)->add_to(tip_in_air(1.0), law);
    EXPECT_EQ(law.own_force, Vector3(1.0, 0.1, 0.7));
}

TEST(EndLoad, LeavesAShaftAlone) {
    Contact shaft = tip_in_air(1.0);
    shaft.tip = false;
    EXPECT_EQ(own_force(step, shaft), Vector3::Zero());
}

std::string refusal(const Case& scene) {
    try {
        (void)contract::make<ForceModel>(STYLET_PLUGIN_FILE, scene);
    } catch (const Error& error) {
        EXPECT_EQ(error.key(), "");
        return error.what();
    }
    return "accepted";
}

TEST(EndLoad, RefusesASceneWithATissue) {
    EXPECT_EQ(refusal({.parameters = step}),
              "found a scene with a tissue, wanted a needle alone: this loads a tip that is in air");
}

TEST(EndLoad, RefusesASceneWithoutANeedle) {
    EXPECT_EQ(refusal({.parameters = step, .has_tissue = false, .has_needle = false}),
              "found a scene without a needle, wanted one whose tip this can load");
}

}    // namespace
}    // namespace stylet
