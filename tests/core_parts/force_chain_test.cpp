#include "core/device/force_chain.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace stylet::core {
namespace {

constexpr double dt = 1e-3;           // [s]
constexpr double rounding = 1e-12;    // sums of a thousand steps of the order one
constexpr double unhurried = 1e9;     // [N/s] a rate that limits nothing
constexpr double at_once = 1e-9;      // [s] of a soft start that nobody feels
constexpr bool fresh = false, stale = true;

// Named so that each test shows what it limits.
DeviceLimits limits_of(double force, double moment, double force_rate, double soft_start) {
    return {.force = force,
            .moment = moment,
            .force_rate = force_rate,
            .soft_start = soft_start,
            .stale_after = 0.01,
            .ramp_down = 0.02};
}

Wrench pull(double force, double moment = 0.0) {
    return {.force = {0.0, 0.6 * force, 0.8 * force}, .moment = {moment, 0.0, 0.0}};
}

TEST(ForceChain, LetsThroughWhatTheDeviceCanBear) {
    ForceChain chain(limits_of(3.0, 0.1, unhurried, at_once), std::nullopt);
    const Wrench out = chain.limit(pull(2.9, 0.09), fresh, dt);
    EXPECT_EQ(out.force, pull(2.9).force);
    EXPECT_EQ(out.moment, pull(0.0, 0.09).moment);
}

TEST(ForceChain, ShortensAForceToTheLowerOfDeviceAndScene) {
    const DeviceLimits device = limits_of(3.0, 0.1, unhurried, at_once);
    EXPECT_NEAR(ForceChain(device, std::nullopt).limit(pull(50.0), fresh, dt).force.norm(), 3.0, rounding);
    EXPECT_NEAR(ForceChain(device, 2.0).limit(pull(50.0), fresh, dt).force.norm(), 2.0, rounding);
    EXPECT_NEAR(ForceChain(device, 9.0).limit(pull(50.0), fresh, dt).force.norm(), 3.0, rounding);
}

TEST(ForceChain, KeepsTheDirectionOfWhatItShortens) {
    ForceChain chain(limits_of(3.0, 0.1, unhurried, at_once), std::nullopt);
    const Wrench out = chain.limit(pull(50.0, -7.0), fresh, dt);
    EXPECT_LE((out.force.normalized() - pull(1.0).force).norm(), rounding);
    EXPECT_LE((out.moment - Vector3(-0.1, 0.0, 0.0)).norm(), rounding);
}

TEST(ForceChain, NeverChangesTheForceFasterThanTheDeviceAllows) {
    constexpr double rate = 200.0;    // [N/s]
    ForceChain chain(limits_of(3.0, 0.1, rate, at_once), std::nullopt);
    Vector3 last = Vector3::Zero();
    for (int tick = 0; tick < 100; ++tick) {
        const Wrench out = chain.limit(pull(tick % 20 < 10 ? 2.0 : -2.0), fresh, dt);
        EXPECT_LE((out.force - last).norm(), rate * dt * (1.0 + rounding)) << "tick " << tick;
        last = out.force;
    }
}

TEST(ForceChain, ReachesASteadyForceInTheTimeThatTheRateTakes) {
    ForceChain chain(limits_of(3.0, 0.1, 200.0, at_once), std::nullopt);
    for (int tick = 1; tick < 10; ++tick) EXPECT_NEAR(chain.limit(pull(2.0), fresh, dt).force.norm(), 0.2 * tick, rounding);
    (void)chain.limit(pull(2.0), fresh, dt);
    EXPECT_NEAR(chain.limit(pull(2.0), fresh, dt).force.norm(), 2.0, rounding);
}

TEST(ForceChain, SlewsTheMomentInTheSameProportion) {
    ForceChain chain(limits_of(3.0, 0.3, 200.0, at_once), std::nullopt);
    EXPECT_NEAR(chain.limit(pull(0.0, 0.3), fresh, dt).moment.norm(), 0.02, rounding);
    EXPECT_NEAR(chain.limit(pull(0.0, 0.3), fresh, dt).moment.norm(), 0.04, rounding);
}

TEST(ForceChain, FadesInFromTheStart) {
    ForceChain chain(limits_of(3.0, 0.1, unhurried, 0.5), std::nullopt);
    for (int tick = 1; tick <= 600; ++tick) {
        const double most = 3.0 * std::min(1.0, tick * dt / 0.5);
        EXPECT_NEAR(chain.limit(pull(100.0), fresh, dt).force.norm(), most, rounding) << "tick " << tick;
    }
}

TEST(ForceChain, TurnsWhatIsNotFiniteIntoZeroForGood) {
    for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        for (const bool in_moment : {false, true}) {
            ForceChain chain(limits_of(3.0, 0.1, unhurried, at_once), std::nullopt);
            (void)chain.limit(pull(1.0), fresh, dt);
            EXPECT_FALSE(chain.faulted());
            const Wrench out = chain.limit(in_moment ? pull(1.0, bad) : pull(bad), fresh, dt);
            EXPECT_EQ(out.force, Vector3::Zero());
            EXPECT_EQ(out.moment, Vector3::Zero());
            EXPECT_TRUE(chain.faulted());
            EXPECT_EQ(chain.limit(pull(1.0), fresh, dt).force, Vector3::Zero());
            EXPECT_TRUE(chain.faulted());
        }
    }
}

constexpr double ramp_down = 0.02;    // [s] of limits_of

/// A chain that has let 2 N through for a while.
ForceChain pulling(double soft_start = at_once) {
    ForceChain chain(limits_of(3.0, 0.1, unhurried, soft_start), std::nullopt);
    for (double time = 0.0; time < 2.0 * soft_start + dt; time += dt) (void)chain.limit(pull(2.0), fresh, dt);
    return chain;
}

TEST(ForceChain, FadesToZeroWhenTrippedAndStaysThere) {
    ForceChain chain = pulling();
    chain.trip();
    EXPECT_TRUE(chain.faulted());
    for (int tick = 1; tick <= 20; ++tick) {
        EXPECT_NEAR(chain.limit(pull(2.0), fresh, dt).force.norm(), 2.0 * (1.0 - tick * dt / ramp_down), rounding);
    }
    for (int tick = 0; tick < 1000; ++tick) EXPECT_LE(chain.limit(pull(2.0), fresh, dt).force.norm(), rounding);
}

TEST(ForceChain, NeverHoldsAStaleForce) {
    ForceChain chain = pulling();
    for (int tick = 1; tick <= 20; ++tick) {
        EXPECT_NEAR(chain.limit(pull(2.5), stale, dt).force.norm(), 2.0 * (1.0 - tick * dt / ramp_down), rounding)
            << "the last good force fades, whatever is asked for";
    }
    for (int tick = 0; tick < 1000; ++tick) EXPECT_LE(chain.limit(pull(2.0), stale, dt).force.norm(), rounding);
}

TEST(ForceChain, RecoversSoftlyFromAStaleMoment) {
    ForceChain chain = pulling(0.1);
    for (int tick = 0; tick < 5; ++tick) (void)chain.limit(pull(2.0), stale, dt);
    EXPECT_FALSE(chain.latched());
    for (int tick = 1; tick <= 25; ++tick) {    // down a quarter in 5 ms, up a quarter in 25 ms
        EXPECT_NEAR(chain.limit(pull(2.0), fresh, dt).force.norm(), 2.0 * (0.75 + tick * dt / 0.1), rounding);
    }
    EXPECT_NEAR(chain.limit(pull(2.0), fresh, dt).force.norm(), 2.0, rounding);
}

TEST(ForceChain, IsReArmedOnlyAfterAWhileWithoutStaleAnswers) {
    ForceChain chain = pulling();
    for (int tick = 0; tick < 30; ++tick) (void)chain.limit(pull(2.0), stale, dt);
    ASSERT_TRUE(chain.latched());
    for (int tick = 0; tick < 60; ++tick) EXPECT_EQ(chain.limit(pull(2.0), fresh, dt).force.norm(), 0.0);
    (void)chain.limit(pull(2.0), stale, dt);    // once more, and the while begins anew
    int ticks = 0;
    while (chain.limit(pull(2.0), fresh, dt).force.norm() == 0.0 && ticks < 1000) ++ticks;
    EXPECT_NEAR(ticks * dt, ForceChain::rearm_after, 2.0 * dt);
    EXPECT_FALSE(chain.latched());
}

TEST(ForceChain, CountsTheTicksOfEachStep) {
    ForceChain chain(limits_of(3.0, 0.1, 500.0, 0.0095), std::nullopt);
    for (int tick = 0; tick < 20; ++tick) (void)chain.limit(pull(5.0), fresh, dt);
    for (int tick = 0; tick < 3; ++tick) (void)chain.limit(pull(5.0), stale, dt);
    (void)chain.limit(pull(std::numeric_limits<double>::infinity()), fresh, dt);
    EXPECT_EQ(chain.counts().magnitude, 20u);
    EXPECT_EQ(chain.counts().slew, 5u) << "0.5 N in the first tick, 3 N within six";
    EXPECT_EQ(chain.counts().soft_start, 9u);
    EXPECT_EQ(chain.counts().stale, 3u);
    EXPECT_EQ(chain.counts().fault, 1u);
}

}    // namespace
}    // namespace stylet::core
