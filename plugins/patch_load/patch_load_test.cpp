#include <stylet/contract/contract.h>

namespace stylet {
namespace {

using contract::Case;

const contract::Given step{
    {"centre", Vector3(0.01, 0.0, 0.0)}, {"size", Vector3(0.021, 0.021, 0.0)}, {"force", Vector3(0.1, 0.0, -1.0)}};

contract::Given with(contract::Given parameters, const std::string& name, const Parameters::Value& value) {
    parameters.set(name, value);
    return parameters;
}

STYLET_CONTRACT(Case{.name = "Step", .parameters = step}, Case{.name = "Ramp", .parameters = with(step, "ramp", 0.5)},
                Case{.name = "TissueAlone", .parameters = step, .has_needle = false})

constexpr double rounding = 1e-15;    // of the force: one multiplication

std::unique_ptr<ForceModel> make(const Case& made) {
    return contract::make<ForceModel>(STYLET_PLUGIN_FILE, made);
}

TEST(PatchLoad, LoadsThePatchThatTheSceneNames) {
    const Case scene{.parameters = step};
    const auto effect = make(scene);
    ASSERT_NE(effect->patch(), nullptr);
    EXPECT_EQ(effect->patch(), effect->patch()) << "lives as long as the effect";
    EXPECT_EQ(effect->patch()->centre, Vector3(0.01, 0.0, 0.0));
    EXPECT_EQ(effect->patch()->size, Vector3(0.021, 0.021, 0.0));
}

TEST(PatchLoad, IsAllThereFromTheFirstInstantOn) {
    const Case scene{.parameters = step};
    const auto effect = make(scene);
    EXPECT_EQ(effect->patch_force(-1.0), Vector3::Zero());
    EXPECT_EQ(effect->patch_force(0.0), Vector3::Zero());
    EXPECT_EQ(effect->patch_force(1e-9), Vector3(0.1, 0.0, -1.0));
    EXPECT_EQ(effect->patch_force(1e9), Vector3(0.1, 0.0, -1.0));
}

TEST(PatchLoad, GrowsLinearlyOverItsRamp) {
    const Case scene{.parameters = with(step, "ramp", 0.5)};
    const auto effect = make(scene);
    EXPECT_EQ(effect->patch_force(0.0), Vector3::Zero());
    EXPECT_LE((effect->patch_force(0.1) - Vector3(0.02, 0.0, -0.2)).norm(), rounding);
    EXPECT_EQ(effect->patch_force(0.5), Vector3(0.1, 0.0, -1.0));
    EXPECT_EQ(effect->patch_force(0.6), Vector3(0.1, 0.0, -1.0));
}

TEST(PatchLoad, LeavesTheContactsAlone) {
    const Case scene{.parameters = step};
    const Contact tip{.tip = true,
                      .inside = false,
                      .layer = 0,
                      .coverage = 0.0,
                      .axial_force = 0.0,
                      .slip = 0.0,
                      .slipping = false,
                      .needle_radius = 0.3e-3,
                      .axis = Vector3(0.0, 0.0, -1.0),
                      .time = 1.0};
    ContactLaw law;
    make(scene)->add_to(tip, law);
    EXPECT_EQ(law.own_force, Vector3::Zero());
    EXPECT_FALSE(law.tip_limited);
    EXPECT_FALSE(law.held);
}

std::string refusal(const Case& scene, const std::string& key) {
    try {
        (void)make(scene);
    } catch (const Error& error) {
        EXPECT_EQ(error.key(), key);
        return error.what();
    }
    return "accepted";
}

TEST(PatchLoad, RefusesASceneWithoutATissue) {
    EXPECT_EQ(refusal({.parameters = step, .has_tissue = false}, ""),
              "found a scene without a tissue, wanted one whose surface this can load");
}

TEST(PatchLoad, RefusesANegativeSide) {
    EXPECT_EQ(refusal({.parameters = with(step, "size", Vector3(0.021, -0.021, 0.0))}, "size"),
              "found a side of -0.021 m, wanted none below zero");
}

}    // namespace
}    // namespace stylet
