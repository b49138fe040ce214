#include <stylet/contract/contract.h>

namespace stylet {
namespace {

using contract::Case;

TissueSetup two_layers() {
    TissueSetup tissue = contract::gel_block();
    tissue.layers.insert(tissue.layers.begin(),
                         {.name = "skin", .youngs_modulus = 60e3, .poisson_ratio = 0.49, .density = 1000.0, .thickness = 5e-3});
    return tissue;
}

STYLET_CONTRACT(Case{.name = "Kinetic", .parameters = {{"per_length", 5.0}}},
                Case{.name = "StickSlip", .parameters = {{"per_length", 5.0}, {"static_per_length", 12.0}}},
                Case{.name = "None", .parameters = {{"per_length", 0.0}}},
                Case{.name = "OneLayer", .parameters = {{"per_length", 5.0}, {"layer", "skin"}}, .tissue = two_layers()})

constexpr double rounding = 1e-16;    // [N] of values below one

Contact shaft(double coverage, bool slipping, int layer = 0) {
    return {.tip = false,
            .inside = true,
            .layer = layer,
            .coverage = coverage,
            .axial_force = 0.0,
            .slip = 0.0,
            .slipping = slipping,
            .needle_radius = 0.3e-3,
            .axis = Vector3(0.0, 0.0, -1.0),
            .time = 0.0};
}

double limit(const Case& with, const Contact& contact) {
    ContactLaw law;
    contract::make<ForceModel>(STYLET_PLUGIN_FILE, with)->add_to(contact, law);
    EXPECT_FALSE(law.tip_limited);
    EXPECT_EQ(law.own_force, Vector3::Zero());
    return law.axial_limit;
}

std::string refusal(const Case& with, const std::string& key) {
    try {
        (void)contract::make<ForceModel>(STYLET_PLUGIN_FILE, with);
    } catch (const Error& error) {
        EXPECT_EQ(error.key(), key);
        return error.what();
    }
    return "accepted";
}

TEST(Friction, GrowsWithTheCoveredLength) {
    const Case with{.parameters = {{"per_length", 5.0}}};
    EXPECT_NEAR(limit(with, shaft(0.005, true)), 0.025, rounding);
    EXPECT_NEAR(limit(with, shaft(0.010, true)), 0.050, rounding);
    EXPECT_EQ(limit(with, shaft(0.0, true)), 0.0);
}

TEST(Friction, HoldsMoreWhileItSticks) {
    const Case with{.parameters = {{"per_length", 5.0}, {"static_per_length", 12.0}}};
    EXPECT_NEAR(limit(with, shaft(0.01, false)), 0.12, rounding);
    EXPECT_NEAR(limit(with, shaft(0.01, true)), 0.05, rounding);
}

TEST(Friction, WithoutAStaticValueSticksAndSlipsAlike) {
    const Case with{.parameters = {{"per_length", 5.0}}};
    EXPECT_EQ(limit(with, shaft(0.01, false)), limit(with, shaft(0.01, true)));
}

TEST(Friction, LeavesTheTipAlone) {
    Contact tip = shaft(0.01, true);
    tip.tip = true;
    EXPECT_EQ(limit({.parameters = {{"per_length", 5.0}}}, tip), 0.0);
}

TEST(Friction, ActsOnlyInItsLayer) {
    const Case with{.parameters = {{"per_length", 5.0}, {"layer", "gel"}}, .tissue = two_layers()};
    EXPECT_EQ(limit(with, shaft(0.01, true, 0)), 0.0);
    EXPECT_NEAR(limit(with, shaft(0.01, true, 1)), 0.05, rounding);
}

TEST(Friction, RefusesAStaticValueBelowTheKineticOne) {
    EXPECT_EQ(refusal({.parameters = {{"per_length", 5.0}, {"static_per_length", 4.5}}}, "static_per_length"),
              "found 4.5 N/m, wanted at least per_length, which is 5 N/m: what sticks holds no less than what slips");
}

TEST(Friction, RefusesALayerThatTheTissueDoesNotHave) {
    EXPECT_EQ(refusal({.parameters = {{"per_length", 5.0}, {"layer", "fat"}}, .tissue = two_layers()}, "layer"),
              "found \"fat\", wanted the name of one of the tissue's layers: skin, gel");
}

}    // namespace
}    // namespace stylet
