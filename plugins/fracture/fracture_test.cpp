#include <stylet/contract/contract.h>

#include <cmath>

namespace stylet {
namespace {

using contract::Case;

TissueSetup two_layers() {
    TissueSetup tissue = contract::gel_block();
    tissue.layers.insert(tissue.layers.begin(),
                         {.name = "skin", .youngs_modulus = 60e3, .poisson_ratio = 0.49, .density = 1000.0, .thickness = 5e-3});
    return tissue;
}

/// The values of the paper's case study.
Case liver() {
    return {.name = "Liver", .parameters = {{"rupture_force", 1.0}, {"toughness", 164.0}}};
}

Case skin_only() {
    return {.name = "OneLayer",
            .parameters = {{"rupture_force", 1.0}, {"toughness", 164.0}, {"layer", "skin"}},
            .tissue = two_layers()};
}

STYLET_CONTRACT(liver(), skin_only(), Case{.name = "NoToughness", .parameters = {{"rupture_force", 0.66}, {"toughness", 0.0}}})

constexpr double cutting_force = 0.30913;    // [N] 2π · 0.3 mm · 164 J/m²
constexpr double last_digit = 0.5e-5;        // [N] of the value above

Contact tip(bool inside, int layer = 0) {
    return {.tip = true,
            .inside = inside,
            .layer = layer,
            .coverage = 0.0,
            .axial_force = 0.0,
            .slip = 0.0,
            .slipping = false,
            .needle_radius = 0.3e-3,
            .axis = Vector3(0.0, 0.0, -1.0),
            .time = 0.0};
}

ContactLaw law(const Case& with, const Contact& contact) {
    ContactLaw law;
    contract::make<ForceModel>(STYLET_PLUGIN_FILE, with)->add_to(contact, law);
    return law;
}

TEST(Fracture, HoldsTheTipOutUpToTheRuptureForce) {
    EXPECT_EQ(law(liver(), tip(false)).tip_limit, 1.0);
    EXPECT_TRUE(law(liver(), tip(false)).tip_limited);
}

TEST(Fracture, CutsInsideAtTwoPiRadiusTimesToughness) {
    EXPECT_NEAR(law(liver(), tip(true)).tip_limit, cutting_force, last_digit);
}

TEST(Fracture, LeavesTheShaftAlone) {
    Contact shaft = tip(true);
    shaft.tip = false;
    EXPECT_FALSE(law(liver(), shaft).tip_limited);
    EXPECT_EQ(law(liver(), shaft).axial_limit, 0.0);
}

TEST(Fracture, ActsOnlyInItsLayer) {
    EXPECT_TRUE(law(skin_only(), tip(true, 0)).tip_limited);
    EXPECT_FALSE(law(skin_only(), tip(true, 1)).tip_limited);
    const auto effect = contract::make<ForceModel>(STYLET_PLUGIN_FILE, skin_only());
    EXPECT_GT(effect->settle({.punctured = false, .cut = 1e-3, .layer = 0, .needle_radius = 0.3e-3}), 0.0);
    EXPECT_EQ(effect->settle({.punctured = false, .cut = 1e-3, .layer = 1, .needle_radius = 0.3e-3}), 0.0);
}

/// The rupture example of 0.2 N/mm, 1 N and no friction: the tip jumps (F_r − F_c)/k = 3.454 mm, which costs F_c times that.
TEST(Fracture, ACutConsumesTheCuttingForceTimesItsLength) {
    constexpr double jump = 3.454e-3;    // [m]
    const auto effect = contract::make<ForceModel>(STYLET_PLUGIN_FILE, liver());
    EXPECT_NEAR((1.0 - law(liver(), tip(true)).tip_limit) / 200.0, jump, 0.5e-6);
    EXPECT_NEAR(effect->settle({.punctured = true, .cut = jump, .layer = 0, .needle_radius = 0.3e-3}), cutting_force * jump,
                last_digit * jump);
}

TEST(Fracture, RefusesALayerThatTheTissueDoesNotHave) {
    Case with = skin_only();
    with.parameters.set("layer", std::string("fat"));
    try {
        (void)contract::make<ForceModel>(STYLET_PLUGIN_FILE, with);
        FAIL() << "accepted";
    } catch (const Error& error) {
        EXPECT_EQ(error.key(), "layer");
        EXPECT_STREQ(error.what(), "found \"fat\", wanted the name of one of the tissue's layers: skin, gel");
    }
}

}    // namespace
}    // namespace stylet
