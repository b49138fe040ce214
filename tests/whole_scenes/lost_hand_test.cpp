// Rows 29, 31 and 32 of the reference's hard cases: a hand that jumps, one that is lost, and one that comes back.
#include "tests/whole_scenes/trace.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace stylet::whole_scenes {
namespace {

constexpr double length = 0.1;        // [m] of the needle in driven.yaml
constexpr double dt = 1e-3;           // [s]
constexpr double lost_at = 0.6;       // [s]
constexpr double rounding = 1e-12;    // of forces of a few newtons
const DeviceLimits& limits = DrivenHand::device_limits;

/// 39 mm in at 100 mm/s, and then held there: the device feels what friction still holds.
Pose in_and_held(double time) {
    return tip_at(std::min(-1e-3 + 0.1 * time, 39e-3), length);
}

/// The magnitude of what the device was told in each tick [N].
struct Felt {
    std::vector<double> force;
    Trace trace;

    [[nodiscard]] double at(double time) const { return force.at(static_cast<std::size_t>(std::lround(time / dt)) - 1); }
};

Felt play_and_feel(const std::function<double(double time)>& age, const Motion& motion = in_and_held, std::size_t ticks = 1500) {
    Stage stage(own_scene("driven"), {}, motion);
    stage.hand().age = age;
    Felt felt{.force = {}, .trace = play(stage, ticks)};
    for (const core::Sample& sample : felt.trace.samples) felt.force.push_back(std::abs(sample.device_force));
    EXPECT_LE(stage.hand().greatest_change, limits.force_rate * dt * (1.0 + rounding) + limits.force * dt / limits.ramp_down);
    expect_sound(felt.trace);
    return felt;
}

/// Nothing is heard of the hand for `duration` [s].
std::function<double(double)> lost_for(double duration) {
    return [duration](double time) { return time < lost_at || time >= lost_at + duration - 1e-9 ? 0.0 : time - lost_at + dt; };
}

TEST(LostHand, OfOneMillisecondIsNotFelt) {
    const Felt never = play_and_feel(nullptr), once = play_and_feel(lost_for(1e-3));
    EXPECT_GT(never.at(lost_at), 0.1) << "there is something to lose";
    EXPECT_EQ(once.force, never.force);
    EXPECT_EQ(once.trace.count("hand lost"), 0u);
}

TEST(LostHand, OfAHundredMillisecondsFadesOutAndComesBackSoftly) {
    constexpr double lost = 0.1;
    const Felt felt = play_and_feel(lost_for(lost));
    print_events(felt.trace);
    EXPECT_EQ(felt.trace.count("hand lost"), 1u);
    EXPECT_EQ(felt.trace.count("hand found"), 1u);
    const double before = felt.at(lost_at - dt), faded = lost_at + limits.stale_after + limits.ramp_down + 2.0 * dt;
    for (double time = faded; time < lost_at + lost + core::ForceChain::rearm_after - 2.0 * dt; time += dt) {
        ASSERT_EQ(felt.at(time), 0.0) << "at " << time << " s";
    }
    EXPECT_NEAR(felt.force.back(), before, 0.01 * before) << "the hand held still";
    double steepest = 0.0;    // [N] in a tick, on the way back
    for (double time = faded; time < 1.4; time += dt) steepest = std::max(steepest, felt.at(time + dt) - felt.at(time));
    measured("steepest", steepest, "N in a tick");
    EXPECT_LE(steepest, before * dt / limits.soft_start * (1.0 + 1e-9)) << "the soft start's own slope";
}

TEST(LostHand, ForEverLeavesNoForce) {
    const Felt felt = play_and_feel(lost_for(std::numeric_limits<double>::infinity()));
    const double gone = lost_at + limits.stale_after + limits.ramp_down + 2.0 * dt;
    for (double time = gone; time < 1.5; time += dt) ASSERT_EQ(felt.at(time), 0.0) << "at " << time << " s";
    EXPECT_EQ(felt.trace.count("hand lost"), 1u);
    EXPECT_EQ(felt.trace.count("hand found"), 0u);
}

TEST(LostHand, WhoseReadingsHaveNoAgeIsLost) {
    const Felt felt = play_and_feel([](double time) { return time < lost_at ? 0.0 : std::nan(""); });
    EXPECT_EQ(felt.force.back(), 0.0);
}

TEST(LostHand, ThatComesBackDeeperIsFeltFromNothing) {
    const Motion deeper = [](double time) { return time < lost_at + 0.1 ? in_and_held(time) : tip_at(50e-3, length); };
    const Felt felt = play_and_feel(lost_for(0.1), deeper);
    print_events(felt.trace);
    EXPECT_EQ(felt.at(lost_at + 0.1), 0.0);
    EXPECT_GT(felt.force.back(), 0.1);
}

TEST(JumpingHand, ByFiftyMillimetresInATickIsSlewedAndRecovers) {
    const Motion jump = [](double time) {
        const bool away = time >= lost_at && time < lost_at + 0.5 * dt;
        return away ? tip_at(-11e-3, length) : in_and_held(time);
    };
    const Felt felt = play_and_feel(nullptr, jump);
    print_events(felt.trace);
    EXPECT_EQ(felt.trace.count("not converged"), 0u);
    EXPECT_GT(felt.trace.samples.back().inserted, 30e-3) << "back in its track";
}

TEST(JumpingHand, ByHalfATurnInATickIsSlewedAndRecovers) {
    const Motion turn = [](double time) {
        Pose pose = in_and_held(time);
        if (time >= lost_at && time < lost_at + 0.1)
            pose.rotation = Quaternion(Eigen::AngleAxisd(std::numbers::pi, Vector3::UnitY()));
        return pose;
    };
    Stage stage(own_scene("driven"), {}, turn);
    const Trace trace = play(stage, 1500);
    print_events(trace);
    double made = 0.0;    // [of the peak work]
    for (const core::Sample& sample : trace.samples) made = std::max(made, -sample.residual / trace.peak_work);
    measured("made", made, "of the peak work");
    EXPECT_LE(made, sound_residual);
    EXPECT_LE(stage.hand().greatest_change, limits.force_rate * dt * (1.0 + rounding) + limits.force * dt / limits.ramp_down);
    EXPECT_LE(stage.hand().greatest_force, limits.force * (1.0 + rounding));
    for (const core::Sample& sample : trace.samples) ASSERT_TRUE(std::isfinite(sample.hand_force));
    EXPECT_TRUE(std::isfinite(trace.samples.back().residual));
}

}    // namespace
}    // namespace stylet::whole_scenes
