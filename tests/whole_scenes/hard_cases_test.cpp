// Rows 19–21, 24–26, 30 and 40 of the reference's hard cases as whole scenes (28 is in cycles_test.cpp). A rigid needle, so that
// the test places the tip itself, unless a case is about something else.
#include "tests/whole_scenes/trace.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace stylet::whole_scenes {
namespace {

constexpr double length = 0.1;           // [m] of the needle in driven.yaml
constexpr double dt = 1e-3;              // [s] its tick
constexpr double rupture_force = 1.0;    // [N] its fracture
constexpr double per_length = 5.0;       // [N/m] its friction
// [N/m] 2aE/(1 − ν²), the tip's stiffness in driven.yaml
const double stiffness = 2.0 * 0.3e-3 * 250e3 / (1.0 - 0.49 * 0.49);

const core::Override only_fracture{"effects", "[{type: fracture, rupture_force: 1 N, toughness: 164 J/m^2}]"};
const core::Override euler{"needle.buckling", "{type: euler}"};

std::size_t tick_of(double time) {
    return static_cast<std::size_t>(std::llround(time / dt));
}

/// The tip at depth depths[i] [m] at the end of tick i, and at depths.front() before the first.
Motion through(std::vector<double> depths) {
    return [depths = std::move(depths)](double time) {
        const std::size_t tick = tick_of(time);
        return tip_at(depths[tick == 0 ? 0 : std::min(tick - 1, depths.size() - 1)], length);
    };
}

/// From depth to depth in equal steps, the last of them `to`.
void ramp(std::vector<double>& depths, double to, int steps) {
    const double from = depths.back();
    for (int i = 1; i <= steps; ++i) depths.push_back(i == steps ? to : from + (to - from) * i / steps);
}

Trace play_depths(const std::vector<double>& depths, const Overrides& overrides) {
    return play(own_scene("driven"), overrides, through(depths), depths.size());
}

class FreeLength : public testing::TestWithParam<const char*> {};

/// Row 19: pushed in until the hand itself is at the tissue, and a millimetre on.
TEST_P(FreeLength, MayShrinkToNothing) {
    Overrides overrides{{"needle.length", "60 mm"},
                        {"needle.type", GetParam()},
                        {"device",
                         "{type: recorded_hand, tip_start: [0 mm, 0 mm, 1 mm], motion: [{insert: 62 mm, speed: 50 mm/s}, "
                         "{withdraw: 20 mm, speed: 50 mm/s}]}"},
                        {"run", "{rate: 1 kHz}"}};
    if (GetParam() == std::string("beam_column")) overrides.push_back(euler);
    const Trace trace = play(own_scene("driven"), overrides);
    print_events(trace);
    EXPECT_EQ(trace.count("base at the tissue"), 1u);
    double greatest = 0.0, shortest = 1.0;
    for (const core::Sample& sample : trace.samples) {
        shortest = std::min(shortest, sample.free_length);
        if (GetParam() == std::string("beam_column")) {
            ASSERT_TRUE(std::isfinite(sample.critical_load));
            greatest = std::max(greatest, sample.critical_load);
        }
    }
    measured("shortest_free_length", shortest, "m");
    measured("greatest_critical_load", greatest, "N");
    EXPECT_EQ(shortest, 0.0);
    EXPECT_EQ(trace.count("not converged"), 0u);
    expect_sound(trace);
}

INSTANTIATE_TEST_SUITE_P(Needle, FreeLength, testing::Values("rigid", "beam_column", "elastica", "rod"),
                         [](const auto& needle) { return std::string(needle.param); });

/// Row 20, outside: a force as continuous as the depth, down to the last bits.
TEST(InsertionDepth, OfNothingGivesNoForce) {
    constexpr double rounding = 1e-12;    // [m] of depth: the tip's place is a difference of 0.1 m, and a sum of two
    const double ulp = std::numeric_limits<double>::denorm_min();
    const std::vector<double> depths{-1e-3, -1e-12, 0.0,    ulp,   1e-15, 1e-12, 0.0, 1e-12,
                                     1e-9,  1e-12,  -1e-12, 1e-12, 1e-9,  1e-6,  0.0, 1e-3};
    const Trace trace = play_depths(depths, {});
    print_events(trace);
    double worst = 0.0;
    for (std::size_t tick = 0; tick < depths.size(); ++tick) {
        worst = std::max(worst, std::abs(trace.samples[tick].hand_force - stiffness * std::max(0.0, depths[tick])));
    }
    measured("worst_error", worst, "N");
    EXPECT_LE(worst, rounding * stiffness);
    EXPECT_EQ(trace.count("punctured"), 0u);
    expect_sound(trace);
}

/// Row 20, inside: where cutting takes as much as the rupture did, the tip goes in by nothing and the force has no step.
TEST(InsertionDepth, GrowsFromNothingWhereTheRuptureReleasesNothing) {
    constexpr double rounding = 1e-9;    // [N]
    const double toughness = rupture_force / (2.0 * std::numbers::pi * 0.3e-3);
    const double at_rupture = rupture_force / stiffness;
    std::vector<double> depths{-1e-4, 0.9 * at_rupture, at_rupture};
    for (const double beyond : {1e-15, 1e-12, 2e-12, 1e-9, 1e-12, 1e-9, 1e-6, 1e-4}) depths.push_back(at_rupture + beyond);
    char fracture[120];
    std::snprintf(fracture, sizeof fracture, "[{type: fracture, rupture_force: 1 N, toughness: %.17g J/m^2}]", toughness);
    const Trace trace = play_depths(depths, {{"effects", fracture}});
    print_events(trace);
    EXPECT_EQ(trace.count("punctured"), 1u);
    for (std::size_t tick = 2; tick < depths.size(); ++tick) {
        // Back by a nanometre the tip holds less; everywhere else it cuts at its limit.
        EXPECT_NEAR(trace.samples[tick].hand_force, rupture_force, stiffness * 1e-9 + rounding) << "at " << depths[tick];
    }
    measured("inserted", trace.samples.back().inserted, "m");
    EXPECT_NEAR(trace.samples.back().inserted, 1e-4, 1e-8);
    expect_sound(trace);
}

/// Row 20, on the way out: a picometre of track left, none, and in again.
TEST(InsertionDepth, ShrinksToNothingWithoutAStep) {
    std::vector<double> depths{-1e-3};
    ramp(depths, 8e-3, 90);
    ramp(depths, 1e-6, 90);
    const std::size_t free_from = depths.size();
    for (const double depth : {1e-9, 1e-12, 0.0, -1e-12, 1e-12, 1e-9, 1e-6, 1e-12, 0.0, 1e-12}) depths.push_back(depth);
    const Trace trace = play_depths(depths, {only_fracture});
    print_events(trace);
    constexpr double rounding = 1e-9;    // [N] nothing holds the tip in its own track where there is no friction
    for (std::size_t tick = free_from; tick < depths.size(); ++tick) {
        EXPECT_NEAR(trace.samples[tick].hand_force, 0.0, rounding) << "at " << depths[tick];
        EXPECT_NEAR(trace.samples[tick].inserted, std::max(0.0, depths[tick]), 1e-12) << "at " << depths[tick];
    }
    EXPECT_EQ(trace.count("punctured"), 1u);
    expect_sound(trace);
}

const core::Override two_layers{"tissue.layers",
                                "[{name: skin, youngs_modulus: 250 kPa, poisson_ratio: 0.49, thickness: 5 mm},"
                                " {name: gel, youngs_modulus: 25 kPa, poisson_ratio: 0.49}]"};
const core::Override two_frictions{
    "effects",
    "[{type: fracture, rupture_force: 1 N, toughness: 164 J/m^2, layer: skin},"
    " {type: fracture, rupture_force: 1 N, toughness: 50 J/m^2, layer: gel},"
    " {type: friction, per_length: 5 N/m, layer: skin}, {type: friction, per_length: 2 N/m, layer: gel}]"};

/// Row 21, the tissue alone: one owner each side of an interface and on it.
TEST(Interface, BelongsToOneLayer) {
    Stage stage(own_scene("driven"), {two_layers});
    const double interface = 5e-3;
    const auto layer_at = [&](double depth) { return stage.cast().tissue().locate({0.0, 0.0, -depth}).layer; };
    EXPECT_EQ(layer_at(std::nextafter(interface, 0.0)), 0);
    EXPECT_EQ(layer_at(interface), 1);
    EXPECT_EQ(layer_at(std::nextafter(interface, 1.0)), 1);
    EXPECT_EQ(layer_at(0.0), 0);
    EXPECT_EQ(layer_at(0.15), 1);
    EXPECT_EQ(layer_at(std::nextafter(0.15, 1.0)), outside);
}

/// Row 21, in a scene: the tip back in its own track, on the interface to the bit and one step of a double to either side.
TEST(Interface, MakesNoChatterUnderTheTip) {
    const double interface = 5e-3;
    std::vector<double> depths{-1e-3};
    ramp(depths, 20e-3, 100);
    ramp(depths, interface, 100);
    for (int i = 0; i < 20; ++i) depths.push_back(interface);    // friction's law follows the covered length with a tick's delay
    const std::size_t from = depths.size();
    const double steps[] = {std::nextafter(interface, 0.0), interface, std::nextafter(interface, 1.0), interface};
    for (int i = 0; i < 200; ++i) depths.push_back(steps[i % 4]);
    const Trace trace = play_depths(depths, {two_layers, two_frictions});
    print_events(trace);
    constexpr double still = 1e-9;    // [N] a hand that moves by 1e-18 m
    double least = 1e9, greatest = -1e9;
    for (std::size_t tick = from; tick < depths.size(); ++tick) {
        least = std::min(least, trace.samples[tick].hand_force);
        greatest = std::max(greatest, trace.samples[tick].hand_force);
    }
    measured("force_range", greatest - least, "N");
    EXPECT_LE(greatest - least, still);
    for (const Happening& event : trace.events) EXPECT_LT(event.tick, from) << event.name;
    expect_sound(trace);
}

class Speed : public testing::TestWithParam<double> {};

/// Row 24: at 1 m/s the rupture and the way to it lie in one or two ticks.
TEST_P(Speed, LeavesARuptureOneEventAndItsSurplusInTheBooks) {
    const double speed = GetParam();
    const Motion push = [&](double time) { return tip_at(std::min(-1e-3 + speed * time, 0.04), length); };
    const Trace trace = play(own_scene("driven"), {}, push, tick_of(0.045 / speed + 0.01));
    print_events(trace);
    ASSERT_EQ(trace.count("punctured"), 1u);
    const std::size_t tick = trace.first("punctured")->tick;
    measured("burst", trace.samples[tick].burst, "J");
    measured("residual", trace.relative);
    EXPECT_GT(trace.samples[tick].burst, 0.0);
    EXPECT_EQ(trace.count("not converged"), 0u);
    expect_sound(trace);
}

INSTANTIATE_TEST_SUITE_P(MetresPerSecond, Speed, testing::Values(0.01, 0.1, 0.3, 1.0, 10.0));

/// Row 25: a hand that keeps the tip within a billionth of the rupture force, and then ten billionths above.
TEST(RuptureForce, HeldWithinABillionthMakesNoPunctureLoop) {
    const double at_rupture = rupture_force / stiffness;
    std::vector<double> depths{-1e-4};
    ramp(depths, at_rupture * (1.0 - 1e-9), 50);
    const std::size_t held = depths.size();
    for (int i = 0; i < 500; ++i) depths.push_back(at_rupture * (1.0 - 1e-9 * (1 + i % 2)));
    const std::size_t around = depths.size();
    for (int i = 0; i < 500; ++i) depths.push_back(at_rupture * (1.0 + 1e-9 * (i % 2 == 0 ? 1 : -1)));
    const std::size_t above = depths.size();
    for (int i = 0; i < 500; ++i) depths.push_back(at_rupture * (1.0 + 1e-8 * (i % 2 == 0 ? 1 : -1)));
    const Trace trace = play_depths(depths, {});
    print_events(trace);
    // A billionth is the coupling's own tolerance: whether it punctures already there is open, but it does so once.
    ASSERT_EQ(trace.count("punctured"), 1u);
    EXPECT_GE(trace.first("punctured")->tick, around);
    EXPECT_LE(trace.first("punctured")->tick, above);
    EXPECT_EQ(trace.events.size(), 2u) << "touched and punctured, nothing else";
    for (std::size_t tick = held; tick < around; ++tick) ASSERT_NEAR(trace.samples[tick].hand_force, rupture_force, 1e-8);
    expect_sound(trace);
}

class Reversal : public testing::TestWithParam<double> {};

/// Row 26: inserted, then a hand that turns back every tick.
TEST_P(Reversal, LeavesFrictionPassiveAndBelowItsLimit) {
    const double way = GetParam();
    std::vector<double> depths{-1e-3};
    ramp(depths, 30e-3, 300);
    const std::size_t from = depths.size();
    for (int i = 0; i < 500; ++i) depths.push_back(30e-3 + (i % 2 == 0 ? -way : way));
    const Trace trace = play_depths(depths, {});
    constexpr double rounding = 1e-12;
    double least_work = 1.0;
    for (std::size_t tick = from; tick < depths.size(); ++tick) {
        const core::Sample &now = trace.samples[tick], &before = trace.samples[tick - 1];
        least_work = std::min(least_work, now.friction - before.friction);
        const double covered = std::max(before.inserted, now.inserted);    // the law of a tick knows the length at its beginning
        ASSERT_LE(std::abs(now.friction_force), per_length * covered * (1.0 + rounding)) << "at tick " << tick;
    }
    measured("least_friction_work_of_a_tick", least_work, "J");
    measured("residual", trace.relative);
    measured("friction_work", trace.samples.back().friction - trace.samples[from].friction, "J");
    EXPECT_GE(least_work, -rounding * trace.peak_work) << "friction gave work back";
    expect_sound(trace);
}

// The last is 1 m/s, far above any hand's.
INSTANTIATE_TEST_SUITE_P(Metres, Reversal, testing::Values(1e-12, 1e-9, 1e-6, 1e-4, 5e-4));

/// Row 30.
class BadPose : public testing::TestWithParam<double> {};

TEST_P(BadPose, TakesTheForceToZeroAndIsNamed) {
    constexpr double lost = 0.05;          // [s]
    constexpr double found_again = 0.1;    // [s] the fault stays: a hand must be re-armed
    const double nothing = GetParam();
    Stage stage(own_scene("driven"), {}, [&](double time) {
        Pose pose = tip_at(std::min(-1e-3 + 0.1 * time, 0.003), length);
        if (time >= lost && time < found_again) pose.position.x() = nothing;
        if (time >= 0.07 && time < found_again) pose.rotation.w() = nothing;
        return pose;
    });
    const Trace trace = play(stage, 200);
    print_events(trace);
    const std::size_t tick = tick_of(lost) - 1;
    ASSERT_EQ(trace.count("fault: the device's pose is not finite"), 1u);
    EXPECT_EQ(trace.first("fault: the device's pose is not finite")->tick, tick);
    EXPECT_TRUE(stage.simulation().faulted());
    EXPECT_GT(std::abs(trace.samples[tick - 1].device_force), 0.1) << "there was nothing to take to zero";
    double before = std::abs(trace.samples[tick - 1].device_force);
    const double fade = before * dt / DrivenHand::device_limits.ramp_down * (1.0 - 1e-9);    // [N] in a tick
    for (std::size_t i = tick; i < trace.samples.size(); ++i) {
        const double now = std::abs(trace.samples[i].device_force);
        EXPECT_LE(now, std::max(1e-12, before - fade)) << "at tick " << i;
        before = now;
    }
    EXPECT_EQ(stage.hand().last.force.norm(), 0.0);
    EXPECT_EQ(stage.hand().last.moment.norm(), 0.0);
    expect_sound(trace);
}

INSTANTIATE_TEST_SUITE_P(Value, BadPose,
                         testing::Values(std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
                                         -std::numeric_limits<double>::infinity()));

/// Row 40: through a block 30 mm deep and 20 mm out at its back, and out again.
TEST(ThroughTheBack, IsNamedAndFrictionHoldsOnlyWhatIsInside) {
    constexpr double block = 0.03;    // [m]
    std::vector<double> depths{-1e-3};
    ramp(depths, 70e-3, 700);
    const std::size_t out = depths.size();
    ramp(depths, -2e-3, 700);
    const Trace trace = play_depths(depths, {{"tissue.extent", "[400 mm, 400 mm, 30 mm]"}});
    print_events(trace);
    ASSERT_EQ(trace.count("left the tissue"), 1u);
    EXPECT_EQ(trace.count("punctured"), 1u);
    EXPECT_EQ(trace.count("withdrawn"), 1u);
    for (const core::Sample& sample : trace.samples) {
        ASSERT_LE(std::abs(sample.friction_force), per_length * block * (1.0 + 1e-9)) << "at " << sample.time << " s";
    }
    const core::Sample& through = trace.samples[out - 1];
    measured("friction_force_through", through.friction_force, "N");
    measured("tip_force_through", through.tip_force, "N");
    EXPECT_NEAR(through.friction_force, per_length * block, 1e-9) << "slips all along";
    EXPECT_EQ(through.tip_force, 0.0);
    EXPECT_NEAR(trace.samples.back().hand_force, 0.0, 1e-9);
    expect_sound(trace);
}

}    // namespace
}    // namespace stylet::whole_scenes
