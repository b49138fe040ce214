// The energy ledger in every scene of the paper, the paper's Eq. (7) beside the base reaction, and a rupture with a known loss.
#include "tests/whole_scenes/trace.h"

#include <gtest/gtest.h>

#include <cmath>

namespace stylet::whole_scenes {
namespace {

class PaperScene : public testing::TestWithParam<const char*> {};

TEST_P(PaperScene, ClosesItsBooks) {
    constexpr double pushing = 1e-6;    // of the peak work, until the first puncture: the bound
    const Trace trace = play(paper_scene(GetParam()));
    measured("relative", trace.relative);
    measured("relative_pushing", trace.relative_pushing);
    ASSERT_GT(trace.peak_work, 0.0);
    EXPECT_LE(trace.relative_pushing, pushing);
    expect_sound(trace);
}

TEST_P(PaperScene, NeverTakesWorkBackFromFrictionCuttingOrRupture) {
    constexpr double rounding = 1e-12;    // of the peak work
    // A tick in which the tip first sticks and then cuts is booked by the trapezoid rule, which gives half of what the tip's
    // force still lacked times the tick's way: ½ · 20 N/m · (10 µm)².
    constexpr double trapezoid = 1e-9;    // [J]
    const Trace trace = play(paper_scene(GetParam()));
    for (std::size_t tick = 1; tick < trace.samples.size(); ++tick) {
        const core::Sample &now = trace.samples[tick], &before = trace.samples[tick - 1];
        ASSERT_GE(now.friction, before.friction - rounding * trace.peak_work) << "at " << now.time << " s";
        ASSERT_GE(now.fracture, before.fracture) << "at " << now.time << " s";
        ASSERT_GE(now.burst, before.burst - trapezoid) << "at " << now.time << " s";
    }
}

/// Eq. (7) is the balance over a tick, so what it gives is compared with the mean of the base reaction at the tick's two ends;
/// both errors are relative to the run's largest base reaction.
TEST_P(PaperScene, GivesTheBaseReactionByEnergyToo) {
    constexpr double rms_bound = 1e-3, worst_bound = 1e-2;    // the issue's
    const Trace trace = play(paper_scene(GetParam()));
    const double peak = trace.peak_hand_force();
    double squares = 0.0, worst = 0.0;
    std::size_t counted = 0;
    for (std::size_t tick = 1; tick < trace.samples.size(); ++tick) {
        const bool rupture = std::ranges::any_of(
            trace.events, [&](const Happening& event) { return event.tick == tick && event.name == "punctured"; });
        if (rupture) continue;
        const core::Sample& now = trace.samples[tick];
        const double error = std::abs(now.energy_force - 0.5 * (trace.samples[tick - 1].hand_force + now.hand_force)) / peak;
        squares += error * error;
        worst = std::max(worst, error);
        ++counted;
    }
    const double rms = std::sqrt(squares / static_cast<double>(counted));
    measured("rms", rms);
    measured("worst", worst);
    EXPECT_LE(rms, rms_bound);
    EXPECT_LE(worst, worst_bound);
}

INSTANTIATE_TEST_SUITE_P(Paper, PaperScene,
                         testing::Values("fig9", "fig10a_l150", "fig10a_l200", "fig10a_l300", "fig10b_r025", "fig10b_r030",
                                         "fig10b_r035", "fig10b_r040"),
                         [](const auto& scene) { return std::string(scene.param); });

/// validation.md, "Friction, rupture, cutting": stiffness 0.2 N/mm, rupture at 1 N, 164 J/m², r = 0.3 mm, no friction. The
/// modulus gives the punch that stiffness: E = k(1 − ν²)/(2a).
TEST(Rupture, JumpsAndLosesWhatTheKnownExampleDoes) {
    constexpr double jump = 3.454e-3, loss = 1.193e-3, cutting_force = 0.309;    // [m], [J], [N]
    constexpr double published = 0.01;                                           // the bound
    const Overrides example{
        {"tissue.layers[0].youngs_modulus", "253300 Pa"},
        {"effects", "[{type: fracture, rupture_force: 1 N, toughness: 164 J/m^2}]"},
        {"device",
         "{type: recorded_hand, tip_start: [0 mm, 0 mm, 0.1 mm], motion: [{insert: 6 mm, speed: 1 mm/s}]}"},    // 1 µm a tick
        {"run", "{rate: 1 kHz}"}};
    const Trace trace = play(own_scene("driven"), example);
    print_events(trace);
    ASSERT_EQ(trace.count("punctured"), 1u);
    const std::size_t tick = trace.first("punctured")->tick;
    measured("jump", trace.samples[tick].inserted, "m");
    measured("loss", trace.samples[tick].burst, "J");
    EXPECT_NEAR(trace.samples[tick - 1].inserted, 0.0, 0.0);
    EXPECT_NEAR(trace.samples[tick].inserted, jump, published * jump);
    EXPECT_NEAR(trace.samples[tick].burst, loss, published * loss);
    EXPECT_NEAR(trace.samples[tick].hand_force, cutting_force, published * cutting_force);
    EXPECT_NEAR(trace.samples.back().burst, trace.samples[tick].burst, published * loss) << "a burst after the rupture";
    expect_sound(trace);
}

}    // namespace
}    // namespace stylet::whole_scenes
