#include "core/device/force_limiter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace stylet::core {
namespace {

constexpr double dt = 1e-3;           // [s]
constexpr double rounding = 1e-12;    // sums of a thousand steps of the order one
constexpr double unhurried = 1e9;     // [N/s] a rate that limits nothing

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

TEST(ForceLimiter, LetsThroughWhatTheDeviceCanBear) {
    ForceLimiter limiter(limits_of(3.0, 0.1, unhurried, 0.0), std::nullopt);
    const Wrench out = limiter.limit(pull(2.9, 0.09), dt);
    EXPECT_EQ(out.force, pull(2.9).force);
    EXPECT_EQ(out.moment, pull(0.0, 0.09).moment);
}

TEST(ForceLimiter, ShortensAForceToTheLowerOfDeviceAndScene) {
    const DeviceLimits device = limits_of(3.0, 0.1, unhurried, 0.0);
    EXPECT_NEAR(ForceLimiter(device, std::nullopt).limit(pull(50.0), dt).force.norm(), 3.0, rounding);
    EXPECT_NEAR(ForceLimiter(device, 2.0).limit(pull(50.0), dt).force.norm(), 2.0, rounding);
    EXPECT_NEAR(ForceLimiter(device, 9.0).limit(pull(50.0), dt).force.norm(), 3.0, rounding);
}

TEST(ForceLimiter, KeepsTheDirectionOfWhatItShortens) {
    ForceLimiter limiter(limits_of(3.0, 0.1, unhurried, 0.0), std::nullopt);
    const Wrench out = limiter.limit(pull(50.0, -7.0), dt);
    EXPECT_LE((out.force.normalized() - pull(1.0).force).norm(), rounding);
    EXPECT_LE((out.moment - Vector3(-0.1, 0.0, 0.0)).norm(), rounding);
}

TEST(ForceLimiter, NeverChangesTheForceFasterThanTheDeviceAllows) {
    constexpr double rate = 200.0;    // [N/s]
    ForceLimiter limiter(limits_of(3.0, 0.1, rate, 0.0), std::nullopt);
    Vector3 last = Vector3::Zero();
    for (int tick = 0; tick < 100; ++tick) {
        const Wrench out = limiter.limit(pull(tick % 20 < 10 ? 2.0 : -2.0), dt);
        EXPECT_LE((out.force - last).norm(), rate * dt * (1.0 + rounding)) << "tick " << tick;
        last = out.force;
    }
}

TEST(ForceLimiter, ReachesASteadyForceInTheTimeThatTheRateTakes) {
    ForceLimiter limiter(limits_of(3.0, 0.1, 200.0, 0.0), std::nullopt);
    for (int tick = 1; tick < 10; ++tick) EXPECT_NEAR(limiter.limit(pull(2.0), dt).force.norm(), 0.2 * tick, rounding);
    (void)limiter.limit(pull(2.0), dt);
    EXPECT_NEAR(limiter.limit(pull(2.0), dt).force.norm(), 2.0, rounding);
}

TEST(ForceLimiter, SlewsTheMomentInTheSameProportion) {
    ForceLimiter limiter(limits_of(3.0, 0.3, 200.0, 0.0), std::nullopt);
    EXPECT_NEAR(limiter.limit(pull(0.0, 0.3), dt).moment.norm(), 0.02, rounding);
    EXPECT_NEAR(limiter.limit(pull(0.0, 0.3), dt).moment.norm(), 0.04, rounding);
}

TEST(ForceLimiter, FadesInFromTheStart) {
    ForceLimiter limiter(limits_of(3.0, 0.1, unhurried, 0.5), std::nullopt);
    for (int tick = 1; tick <= 600; ++tick) {
        const double most = 3.0 * std::min(1.0, tick * dt / 0.5);
        EXPECT_NEAR(limiter.limit(pull(100.0), dt).force.norm(), most, rounding) << "tick " << tick;
    }
}

TEST(ForceLimiter, TurnsWhatIsNotFiniteIntoZeroForGood) {
    for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        for (const bool in_moment : {false, true}) {
            ForceLimiter limiter(limits_of(3.0, 0.1, unhurried, 0.0), std::nullopt);
            (void)limiter.limit(pull(1.0), dt);
            EXPECT_FALSE(limiter.faulted());
            const Wrench out = limiter.limit(in_moment ? pull(1.0, bad) : pull(bad), dt);
            EXPECT_EQ(out.force, Vector3::Zero());
            EXPECT_EQ(out.moment, Vector3::Zero());
            EXPECT_TRUE(limiter.faulted());
            EXPECT_EQ(limiter.limit(pull(1.0), dt).force, Vector3::Zero());
            EXPECT_TRUE(limiter.faulted());
        }
    }
}

TEST(ForceLimiter, RampsToZeroWhenTrippedAndStaysThere) {
    ForceLimiter limiter(limits_of(3.0, 0.1, 200.0, 0.0), std::nullopt);
    for (int tick = 0; tick < 20; ++tick) (void)limiter.limit(pull(2.0), dt);
    limiter.trip();
    EXPECT_TRUE(limiter.faulted());
    for (int tick = 1; tick <= 9; ++tick) {
        EXPECT_NEAR(limiter.limit(pull(2.0), dt).force.norm(), 2.0 - 0.2 * tick, rounding) << "tick " << tick;
    }
    for (int tick = 10; tick <= 30; ++tick) EXPECT_LE(limiter.limit(pull(2.0), dt).force.norm(), rounding);
    EXPECT_EQ(limiter.limit(pull(2.0), dt).force, Vector3::Zero());
}

}    // namespace
}    // namespace stylet::core
