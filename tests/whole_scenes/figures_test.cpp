// Figs. 9 and 10 of the paper, as the mechanics gives them (reference: paper_findings, "Fig. 10").
#include "core/run/run.h"
#include "tests/whole_scenes/trace.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace stylet::whole_scenes {
namespace {

constexpr double published = 0.01;    // relative: the figures are read off the paper to about two digits; the bound

void expect_buckling_outside(const std::string& scene, double load) {
    const Trace trace = play(paper_scene(scene));
    print_events(trace);
    const Happening* const buckled = trace.first("buckled");
    ASSERT_NE(buckled, nullptr);
    measured("buckled_at", buckled->hand_force, "N");
    EXPECT_NEAR(buckled->hand_force, load, published * load);
    EXPECT_NEAR(buckled->critical_load, load, published * load);
    EXPECT_EQ(trace.count("punctured"), 0u);
    EXPECT_EQ(trace.count("buckled"), 1u);
    expect_sound(trace);

    const core::RunReport report = core::run(core::read_scene(paper_scene(scene), {}, plugin_folders()), plugin_folders(), {});
    ASSERT_EQ(report.buckling.size(), 1u);
    EXPECT_EQ(report.buckling[0].force, buckled->hand_force);
    EXPECT_EQ(report.events.back().name, "never punctured");
    EXPECT_EQ(report.ledger.relative, trace.relative);
    EXPECT_EQ(report.ledger.relative_pushing, trace.relative_pushing);
}

void expect_puncture_without_buckling(const std::string& scene, double load) {
    const Trace trace = play(paper_scene(scene));
    print_events(trace);
    const Happening* const punctured = trace.first("punctured");
    ASSERT_NE(punctured, nullptr);
    measured("punctured_at", punctured->hand_force, "N");
    EXPECT_NEAR(punctured->hand_force, load, published * load);
    EXPECT_EQ(trace.count("punctured"), 1u);
    EXPECT_EQ(trace.count("buckled"), 0u) << "before the puncture";
    expect_sound(trace);
}

TEST(Figure10a, TheNeedleOf150mmPuncturesAtOneNewtonWithoutBuckling) {
    expect_puncture_without_buckling("fig10a_l150", 1.0);
}

TEST(Figure10a, TheNeedleOf200mmBucklesAndStaysOutside) {
    expect_buckling_outside("fig10a_l200", 0.642);
}

TEST(Figure10a, TheNeedleOf300mmBucklesAtASmallerForceAndStaysOutside) {
    expect_buckling_outside("fig10a_l300", 0.285);
}

TEST(Figure10b, TheThinnestNeedleBucklesAndStaysOutside) {
    expect_buckling_outside("fig10b_r025", 0.310);
}

TEST(Figure10b, ANeedleOfThreeTenthsBucklesAndStaysOutside) {
    expect_buckling_outside("fig10b_r030", 0.642);
}

TEST(Figure10b, ANeedleOf35HundredthsPuncturesWithoutBuckling) {
    expect_puncture_without_buckling("fig10b_r035", 1.0);
}

TEST(Figure10b, TheThickestNeedlePuncturesWithoutBuckling) {
    expect_puncture_without_buckling("fig10b_r040", 1.0);
}

TEST(Figure9, TouchesBucklesPuncturesStraightensAndBucklesAgain) {
    const Trace trace = play(paper_scene("fig9"));
    print_events(trace);
    std::vector<std::string> names = trace.names();
    std::erase(names, "crossed an interface");    // the scene's two layers differ in friction alone
    ASSERT_GE(names.size(), 5u);
    names.resize(5);
    EXPECT_EQ(names, (std::vector<std::string>{"touched", "buckled", "punctured", "straightened", "second buckling"}));
    EXPECT_NEAR(trace.first("buckled")->hand_force, 0.642, published * 0.642);
    EXPECT_NEAR(trace.first("punctured")->hand_force, 0.66, published * 0.66);
    const Happening& again = *trace.first("second buckling");
    EXPECT_NEAR(again.hand_force, again.critical_load, published * again.critical_load);
    EXPECT_GT(again.critical_load, trace.first("buckled")->critical_load) << "its free length is shorter by then";
    expect_sound(trace);
}

const Overrides without_friction{{"effects", "[{type: fracture, rupture_force: 1 N, toughness: 164 J/m^2}]"}};

TEST(Puncture, DropsTheForceInTheSameTick) {
    constexpr double greatest_left = 0.6;    // of the rupture force: cutting 0.31 N, and friction along the 30 mm of the jump
    const Trace trace = play(paper_scene("fig10a_l150"));
    const Happening* const punctured = trace.first("punctured");
    ASSERT_NE(punctured, nullptr);
    const double before = trace.samples[punctured->tick - 1].hand_force, after = trace.samples[punctured->tick].hand_force;
    measured("hand_force_before", before, "N");
    measured("hand_force_after", after, "N");
    EXPECT_NEAR(before, 1.0, published);
    EXPECT_LT(after, greatest_left * before);
}

TEST(Puncture, SettlesAtTheCuttingForceWhereThereIsNoFriction) {
    constexpr double cutting_force = 0.309;    // [N] 2π r J_c
    const Trace trace = play(paper_scene("fig10a_l150"), without_friction);
    const Happening* const punctured = trace.first("punctured");
    ASSERT_NE(punctured, nullptr);
    measured("settled_at", trace.samples.back().hand_force, "N");
    for (std::size_t tick = punctured->tick; tick < trace.samples.size(); ++tick) {
        ASSERT_NEAR(trace.samples[tick].hand_force, cutting_force, published * cutting_force) << "at tick " << tick;
    }
    expect_sound(trace);
}

TEST(Puncture, IsFollowedByAForceThatRisesWithDepthByFriction) {
    constexpr double per_length = 5.0;    // [N/m] the scene's friction
    constexpr double entering = 0.05;     // of the rise: the piece of shaft that is just entering its contact
    const Trace trace = play(paper_scene("fig10a_l150"));
    const Happening* const punctured = trace.first("punctured");
    ASSERT_NE(punctured, nullptr);
    // From where the shaft slips all along: the tissue has by then been dragged to its limit again.
    const core::Sample& end = trace.samples.back();
    const std::size_t middle = (punctured->tick + trace.samples.size()) / 2;
    for (std::size_t tick = punctured->tick + 1; tick < trace.samples.size(); ++tick) {
        ASSERT_GE(trace.samples[tick].hand_force, trace.samples[tick - 1].hand_force - 1e-6) << "at tick " << tick;
    }
    const double rise = end.hand_force - trace.samples[middle].hand_force;
    const double deeper = end.inserted - trace.samples[middle].inserted;
    measured("rise_per_length", rise / deeper, "N/m");
    EXPECT_NEAR(rise / deeper, per_length, entering * per_length);
}

/// 20.19 EI/L_f² (Euler, clamped and pinned), written out here independently of the plugin.
TEST(CriticalLoad, FollowsTheFreeLengthAsItShrinks) {
    constexpr double last_digit = 3e-4;                                                                 // relative: of 20.19
    constexpr double stiffness = 200e9 * std::numbers::pi / 4.0 * 0.3e-3 * 0.3e-3 * 0.3e-3 * 0.3e-3;    // [N·m²] EI
    const Trace trace = play(paper_scene("fig10a_l150"));
    double shortest = 1.0;
    for (const core::Sample& sample : trace.samples) {
        const double load = 20.19 * stiffness / (sample.free_length * sample.free_length);
        ASSERT_NEAR(sample.critical_load, load, last_digit * load) << "at " << sample.time << " s";
        shortest = std::min(shortest, sample.free_length);
    }
    measured("shortest_free_length", shortest, "m");
    EXPECT_LT(shortest, 0.115) << "nothing was inserted";
}

}    // namespace
}    // namespace stylet::whole_scenes
