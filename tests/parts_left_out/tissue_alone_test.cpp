// A tissue alone, loaded by patches of its surface; and beside a needle.
#include "tests/whole_scenes/mapped_plugins.h"
#include "tests/whole_scenes/trace.h"

#include <stylet/contract/allocations.h>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace stylet::whole_scenes {
namespace {

constexpr double accuracy = 1e-6;    // relative: what is promised of a loaded patch
constexpr double books = 1e-6;       // of the peak work: the bound

// Timoshenko and Goodier 1970, article 139, for 1 N on a square of 21 mm, 25 kPa and ν = 0.49.
const double unit = (1.0 - 0.49 * 0.49) / (25e3 * 21e-3);    // [m/N]
const double middle = unit * 4.0 / std::numbers::pi * std::log(1.0 + std::sqrt(2.0));
const double mean = unit * 4.0 / std::numbers::pi * (std::log(1.0 + std::sqrt(2.0)) + (1.0 - std::sqrt(2.0)) / 3.0);

TEST(TissueAlone, SinksUnderASquareAsLoveSays) {
    Stage stage(own_scene("half_space_patch"));
    const Trace trace = play(stage);
    ASSERT_EQ(stage.simulation().loads().count(), 1);
    const Vector3 moved = stage.simulation().loads().displacement(0);
    measured("mean", moved.z(), "m");
    measured("middle", stage.cast().tissue().displacement(Vector3::Zero()).z(), "m");
    EXPECT_NEAR(-moved.z() / mean, 1.0, accuracy);
    EXPECT_NEAR(-stage.cast().tissue().displacement(Vector3::Zero()).z() / middle, 1.0, accuracy);
    EXPECT_LE(moved.head<2>().norm(), accuracy * mean);
    for (const core::Sample& sample : trace.samples)
        EXPECT_EQ(sample.patch_displacement, trace.samples.front().patch_displacement);
    EXPECT_NEAR(trace.samples.front().patch_displacement / mean, 1.0, accuracy) << "along the force, from the first tick on";
    EXPECT_TRUE(trace.events.empty()) << trace.events.front().name;
}

TEST(TissueAlone, FollowsARamp) {
    const Trace trace = play(own_scene("half_space_patch_ramp"));
    ASSERT_EQ(trace.samples.size(), 600u);
    EXPECT_NEAR(trace.samples[249].patch_displacement / mean, 0.5, accuracy);
    EXPECT_NEAR(trace.samples[499].patch_displacement / mean, 1.0, accuracy);
    EXPECT_NEAR(trace.samples[599].patch_displacement / mean, 1.0, accuracy);
}

class LoadedTissue : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Validation, LoadedTissue, testing::Values("half_space_patch", "half_space_patch_ramp"),
                         [](const auto& scene) { return std::string(scene.param); });

TEST_P(LoadedTissue, StoresTheWorkOfItsLoad) {
    const Trace trace = play(own_scene(GetParam()));
    const core::Sample& last = trace.samples.back();
    measured("load_work", last.load_work, "J");
    measured("relative", trace.relative);
    EXPECT_NEAR(last.load_work / (0.5 * mean), 1.0, accuracy) << "half of 1 N along the way";
    EXPECT_NEAR(last.stored, last.load_work, books * last.load_work);
    EXPECT_EQ(last.hand_work, 0.0);
    expect_sound(trace, books);
}

TEST_P(LoadedTissue, BringsNoLibraryOfANeedleOrADevice) {
    {
        Stage stage(own_scene(GetParam()));
        (void)play(stage);
        EXPECT_EQ(mapped_plugins(), (std::vector<std::string>{"half_space", "patch_load"}));
    }
    EXPECT_EQ(mapped_plugins(), std::vector<std::string>{});
}

TEST_P(LoadedTissue, AllocatesNothingInATick) {
    Stage stage(own_scene(GetParam()));
    const std::size_t before = contract::allocations(), ticks = stage.ticks();
    for (std::size_t tick = 0; tick < ticks; ++tick) stage.simulation().tick();
    EXPECT_EQ(contract::allocations() - before, 0u);
}

TEST(TissueAlone, TakesSeveralLoadsThatComeAndStay) {
    const core::Override several{
        "effects",
        "[{type: patch_load, centre: [0 mm, 0 mm, 0 mm], size: [21 mm, 21 mm, 0 mm], force: [0.2 N, 0 N, -1 N]}, "
        "{type: patch_load, centre: [10 mm, 5 mm, 0 mm], size: [5 mm, 30 mm, 0 mm], force: [0 N, -1 N, 0.5 N], "
        "ramp: 0.05 s}]"};
    const Trace trace = play(own_scene("half_space_patch"), {several});
    measured("relative", trace.relative);
    EXPECT_GT(trace.samples.back().load_work, 0.5 * mean);
    expect_sound(trace, books);
}

// A needle that is pushed in beside a patch whose load grows meanwhile: two kinds of work, one balance. The patch takes the
// surface along, away from the tip.
TEST(TissueAndNeedle, KeepTheirBooksBesideALoadedPatch) {
    constexpr double tick = 10e-6;    // [m] of the hand in one
    const std::string load =
        "{type: patch_load, centre: [12 mm, 0 mm, 0 mm], size: [15 mm, 15 mm, 0 mm], force: [0 N, 0 N, -1 N], ramp: 7 s}";
    const core::Override both{
        "effects",
        "[{type: fracture, rupture_force: 1 N, toughness: 164 J/m^2}, {type: friction, per_length: 5 N/m}, " + load + "]"};
    const Trace trace = play(paper_scene("fig10a_l150"), {both}), unloaded = play(paper_scene("fig10a_l150"));
    print_events(trace);
    const Happening *const punctured = trace.first("punctured"), *const before = unloaded.first("punctured");
    ASSERT_NE(punctured, nullptr);
    Stage tissue(own_scene("half_space_patch"), {{"effects", "[" + load + "]"}, {"run.duration", "8 s"}});
    (void)play(tissue, punctured->tick + 1);
    const double sunk = -tissue.cast().tissue().displacement(Vector3::Zero()).z();
    measured("sunk", sunk, "m");
    measured("later", punctured->travel - before->travel, "m");
    measured("load_work", trace.samples.back().load_work, "J");
    EXPECT_NEAR(punctured->travel - before->travel, sunk, tick);
    EXPECT_GT(trace.samples.back().load_work, 0.0);
    EXPECT_LE(trace.relative_pushing, books);
    expect_sound(trace);
}

}    // namespace
}    // namespace stylet::whole_scenes
