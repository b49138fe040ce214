#include <stylet/contract/contract.h>

namespace stylet {
namespace {

using contract::Case;

NeedleSetup held_by(Ends ends) {
    NeedleSetup needle = contract::steel_needle();
    needle.ends = ends;
    return needle;
}

STYLET_CONTRACT(Case{.name = "ClampedPinned", .has_tissue = false},
                Case{.name = "PinnedPinned", .needle = held_by(Ends::pinned_pinned), .has_tissue = false})

Contact contact(bool tip, int layer) {
    return {.tip = tip,
            .inside = !tip,
            .layer = layer,
            .coverage = 0.0,
            .axial_force = 0.0,
            .slip = 0.0,
            .slipping = false,
            .needle_radius = 0.3e-3,
            .axis = Vector3(0.0, 0.0, -1.0),
            .time = 1.0};
}

bool holds(const Contact& of) {
    const Case scene{.has_tissue = false};
    ContactLaw law;
    contract::make<ForceModel>(STYLET_PLUGIN_FILE, scene)->add_to(of, law);
    EXPECT_EQ(law.own_force, Vector3::Zero());
    EXPECT_FALSE(law.tip_limited);
    return law.held;
}

TEST(Pin, HoldsATipInTheAir) {
    EXPECT_TRUE(holds(contact(true, -1)));
}

TEST(Pin, HoldsNothingElse) {
    EXPECT_FALSE(holds(contact(false, -1)));
    EXPECT_FALSE(holds(contact(true, 0)));
}

std::string refusal(const Case& scene, const std::string& key) {
    try {
        (void)contract::make<ForceModel>(STYLET_PLUGIN_FILE, scene);
    } catch (const Error& error) {
        EXPECT_EQ(error.key(), key);
        return error.what();
    }
    return "accepted";
}

TEST(Pin, RefusesASceneWithATissue) {
    EXPECT_EQ(refusal({}, ""), "found a scene with a tissue, wanted a needle alone: this holds a tip that is in air");
}

TEST(Pin, RefusesASceneWithoutANeedle) {
    EXPECT_EQ(refusal({.has_tissue = false, .has_needle = false}, ""),
              "found a scene without a needle, wanted one whose tip this can hold");
}

TEST(Pin, RefusesATipThatTheNeedlesEndsLeaveFree) {
    EXPECT_EQ(refusal({.needle = held_by(Ends::clamped_free), .has_tissue = false}, "needle.ends"),
              "found clamped-free, wanted ends whose tip is held: the scene pins it");
}

}    // namespace
}    // namespace stylet
