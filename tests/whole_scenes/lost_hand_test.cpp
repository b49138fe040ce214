// Rows 29, 31 and 32 of the reference's hard cases: a hand that jumps, one that is lost, and one that comes back.
#include "tests/whole_scenes/trace.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

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
    std::size_t slewed = 0;    // ticks

    /// [N] The greatest change from tick to tick once the soft start is over.
    [[nodiscard]] double greatest_change() const {
        double greatest = 0.0;
        for (auto i = static_cast<std::size_t>(limits.soft_start / dt) + 2; i < trace.samples.size(); ++i)
            greatest = std::max(greatest, std::abs(trace.samples[i].device_force - trace.samples[i - 1].device_force));
        return greatest;
    }
    [[nodiscard]] double at(double time) const { return force.at(static_cast<std::size_t>(std::lround(time / dt)) - 1); }
};

Felt play_and_feel(const std::function<double(double time)>& age, const Motion& motion = in_and_held, std::size_t ticks = 1500) {
    Stage stage(own_scene("driven"), {}, motion);
    stage.hand().age = age;
    Felt felt{.force = {}, .trace = play(stage, ticks)};
    for (const core::Sample& sample : felt.trace.samples) felt.force.push_back(std::abs(sample.device_force));
    felt.slewed = stage.simulation().force_chain().slew;
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

TEST(BrokenHand, ThatThrowsInEveryTickIsToldToLetGo) {
    Stage stage(own_scene("driven"), {}, [](double time) {
        if (time >= lost_at) throw std::runtime_error("a broken cable");
        return in_and_held(time);
    });
    const Trace trace = play(stage, 1500);
    print_events(trace);
    EXPECT_EQ(trace.count("fault: a plugin threw an exception"), 1u);
    const auto before = static_cast<std::size_t>(std::lround(lost_at / dt)) - 2;
    EXPECT_GT(std::abs(trace.samples[before].device_force), 0.1) << "there is something to let go";
    EXPECT_EQ(stage.hand().last.force.norm(), 0.0);
    EXPECT_GT(stage.simulation().force_chain().fault, 0u);
}

TEST(Hand, IsLetGoWhenTheSceneIsOver) {
    Stage stage(own_scene("driven"), {}, in_and_held);
    (void)play(stage, 500);
    EXPECT_GT(stage.hand().last.force.norm(), 0.1);
    int ticks = 0;
    while (stage.simulation().let_go()) ++ticks;
    EXPECT_EQ(stage.hand().last.force.norm(), 0.0);
    EXPECT_NEAR(ticks * dt, limits.ramp_down, 1.5 * dt);
}

TEST(Hand, ThatWasLeftWithAForceForTooLongIsGivenNone) {
    Stage stage(own_scene("driven"), {}, in_and_held);
    (void)play(stage, 500);
    stage.simulation().tick(0.5);    // the loop was late by half a second
    EXPECT_EQ(stage.hand().last.force.norm(), 0.0);
    EXPECT_EQ(stage.simulation().force_chain().stale, 1u);
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
    measured("greatest_change", felt.greatest_change(), "N in a tick");
    EXPECT_GT(felt.slewed, 0u);
    EXPECT_LE(felt.greatest_change(), limits.force_rate * dt * (1.0 + rounding));
}

/// No needle is turned by half a turn within its track: where it ends up is anyone's guess, and it doesn't find back into its old
/// track. What matters then is that the hand is spared: slewed, limited, and given no energy.
TEST(JumpingHand, ByHalfATurnInATickIsSlewedLimitedAndGivenNoEnergy) {
    const Motion turn = [](double time) {
        Pose pose = in_and_held(time);
        if (time >= lost_at && time < lost_at + 0.1)
            pose.rotation = Quaternion(Eigen::AngleAxisd(std::numbers::pi, Vector3::UnitY()));
        return pose;
    };
    Stage stage(own_scene("driven"), {}, turn);
    Felt felt{.force = {}, .trace = play(stage, 1500)};
    print_events(felt.trace);
    double made = 0.0;    // [of the peak work]
    for (const core::Sample& sample : felt.trace.samples) {
        ASSERT_TRUE(std::isfinite(sample.hand_force) && std::isfinite(sample.residual));
        made = std::max(made, -sample.residual / felt.trace.peak_work);
    }
    measured("made", made, "of the peak work");
    measured("greatest_change", felt.greatest_change(), "N in a tick");
    EXPECT_LE(made, sound_residual);
    EXPECT_GT(stage.simulation().force_chain().slew, 0u);
    EXPECT_LE(felt.greatest_change(), limits.force_rate * dt * (1.0 + rounding));
    EXPECT_LE(stage.hand().greatest_force, limits.force * (1.0 + rounding));
}

}    // namespace
}    // namespace stylet::whole_scenes
