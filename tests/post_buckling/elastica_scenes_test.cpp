// What `needle: {type: elastica}` makes of the prepared scenes: the limit load, what holds a needle beyond it, and what a snap
// loses.
#include "tests/whole_scenes/trace.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace stylet::whole_scenes {
namespace {

using testing::Contains;
using testing::Not;

constexpr double limit = 1.1396;      // of P_cr, clamped-pinned (the plugin's own test)
constexpr double validated = 0.01;    // the bound on the limit load
const double stiffness = 200e9 * std::numbers::pi * std::pow(0.3e-3, 4) / 4.0;    // [N·m²]

double critical_load(double length) {    // [N] clamped-pinned
    return std::pow(4.493409457909064, 2) * stiffness / (length * length);
}

const core::Override elastica{.key = "needle.type", .value = "elastica"};

core::Override motion(const std::string& pieces) {
    return {.key = "device.motion", .value = pieces};
}

TEST(ElasticaScenes, ABuckledNeedleNeverPunctures) {
    for (const auto& [name, length] : {std::pair("fig10a_l200", 0.2), std::pair("fig10a_l300", 0.3)}) {
        const Trace trace = play(paper_scene(name), {elastica});
        EXPECT_THAT(trace.names(), Contains("buckled"));
        EXPECT_THAT(trace.names(), Not(Contains("punctured")));
        measured(std::string(name) + " peak", trace.peak_hand_force(), "N");
        EXPECT_GT(trace.peak_hand_force(), critical_load(length));
        EXPECT_LT(trace.peak_hand_force(), limit * critical_load(length));
        expect_sound(trace, 1e-6);    // the bound while pushing
    }
    EXPECT_THAT(play(paper_scene("fig10a_l150"), {elastica}).names(), Contains("punctured"));
}

TEST(ElasticaScenes, PassesItsLimitLoadAgainstAPinAndComesBack) {
    const Trace trace = play(own_scene("column_in_air_pinned"),
                             {elastica, motion("[{insert: 160 mm, speed: 50 mm/s}, {withdraw: 160 mm, speed: 50 mm/s}]")});
    measured("limit load of a clamped-pinned column", trace.peak_hand_force() / critical_load(0.2), "of its critical load");
    EXPECT_NEAR(trace.peak_hand_force() / critical_load(0.2), 1.14, validated * 1.14);
    const auto& turned = trace.samples[trace.samples.size() / 2];
    EXPECT_LT(turned.hand_force, 0.2 * critical_load(0.2)) << "far down the falling branch";
    constexpr double rounding = 1e-12;    // [J] the tip's way is added up over 6400 ticks
    EXPECT_NEAR(trace.samples.back().stored, 0.0, rounding);
    EXPECT_EQ(trace.samples.back().numerical, 0.0) << "nothing snapped";
    EXPECT_THAT(trace.names(), Not(Contains("not converged")));
    expect_sound(trace);
}

TEST(ElasticaScenes, FoldsUpUnderAnEndLoadBeyondItsLimit) {
    const Trace trace =
        play(own_scene("column_in_air_end_load"), {elastica, {.key = "effects[0].force", .value = "[0 N, 0 N, 0.8 N]"}});
    const Happening* folded = trace.first("beyond validity: the needle is folded up");
    ASSERT_NE(folded, nullptr);
    measured("folds up under", folded->hand_force / critical_load(0.2), "of its critical load");
    EXPECT_NEAR(folded->hand_force / critical_load(0.2), limit, 1e-3 * limit);    // the load grows by 6e-4 of that a tick
    EXPECT_GT(trace.samples.back().numerical, 0.0) << "what the snap lost is in the books";
    EXPECT_THAT(trace.names(), Not(Contains("not converged")));
    expect_sound(trace);
}

TEST(ElasticaScenes, SnapsWhereTheTissueIsTooSoftToHoldItAndTheBooksClose) {
    const Trace trace =
        play(paper_scene("fig10a_l200"), {elastica, motion("[{insert: 175 mm, speed: 20 mm/s}, {hold: 100 ms}]")});
    print_events(trace);
    EXPECT_THAT(trace.names(), Contains("beyond validity: the needle is folded up"));
    EXPECT_THAT(trace.names(), Not(Contains("not converged")));
    measured("limit load in tissue", trace.peak_hand_force() / critical_load(0.2), "of its critical load");
    EXPECT_NEAR(trace.peak_hand_force() / critical_load(0.2), 1.14, validated * 1.14);
    EXPECT_GT(trace.samples.back().numerical, 0.0);
    expect_sound(trace, 1e-6);
}

TEST(ElasticaScenes, BucklesTwiceInTheSceneOfFigure9) {
    const Trace trace = play(paper_scene("fig9"), {elastica});
    for (const char* name : {"buckled", "punctured", "straightened", "second buckling"})
        EXPECT_THAT(trace.names(), Contains(name));
    expect_sound(trace);
}

TEST(ElasticaScenes, NeedsNoBucklingModel) {
    constexpr double rounding = 1e-9;    // [N] Euler's load is the elastica's own: what the coupling leaves of a balance
    const Trace given = play(own_scene("column_in_air_pinned"), {elastica});
    const Trace alone = play(std::filesystem::path(POST_BUCKLING_SCENES) / "column_without_model.yaml");
    ASSERT_EQ(given.samples.size(), alone.samples.size());
    for (std::size_t i = 0; i < given.samples.size(); ++i) {
        EXPECT_NEAR(given.samples[i].hand_force, alone.samples[i].hand_force, rounding) << i;
    }
}

}    // namespace
}    // namespace stylet::whole_scenes
