#include "checks.h"

#include <stylet/contract/allocations.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace stylet::contract {
namespace {

constexpr double unit = 1e-12;    // a normalised quaternion's length is off by roundings only

bool same_pose(const Pose& a, const Pose& b) {
    return std::memcmp(a.position.data(), b.position.data(), 3 * sizeof(double)) == 0 &&
           std::memcmp(a.rotation.coeffs().data(), b.rotation.coeffs().data(), 4 * sizeof(double)) == 0;
}

template <class Function>
void with_device(const Descriptor& plugin, const Case& with, Function check) {
    const auto object = make(plugin, with);
    check(static_cast<HapticDevice&>(*object));
}

/// Times that rise by the time step, and what is written between them, as core does it.
template <class Function>
void live(HapticDevice& device, const Case& with, Function at_each) {
    const double end = std::isfinite(device.duration()) ? device.duration() : 10.0;
    const auto ticks = static_cast<int>(std::min(end / with.dt, 5000.0));
    for (int i = 0; i <= ticks; ++i) {
        at_each(device.read(i * with.dt), i * with.dt);
        device.write({Vector3(0.1, -0.2, 0.3 * std::sin(i)), Vector3(0.01, 0.02, -0.03)});
    }
}

void readings_are_finite_and_unit(const Descriptor& plugin, const Case& with) {
    with_device(plugin, with, [&](HapticDevice& device) {
        live(device, with, [](const Reading& reading, double time) {
            EXPECT_TRUE(reading.pose.finite()) << "at " << time << " s";
            EXPECT_NEAR(reading.pose.rotation.norm(), 1.0, unit) << "at " << time << " s";
            EXPECT_GE(reading.age, 0.0) << "at " << time << " s";
        });
    });
}

void the_same_life_is_lived_twice(const Descriptor& plugin, const Case& with) {
    with_device(plugin, with, [&](HapticDevice& device) {
        if (!std::isfinite(device.duration())) return;    // a live hand never repeats itself
        std::vector<Reading> readings;
        live(device, with, [&](const Reading& reading, double) { readings.push_back(reading); });
        const auto other = make(plugin, with);
        std::size_t i = 0;
        live(static_cast<HapticDevice&>(*other), with, [&](const Reading& reading, double time) {
            EXPECT_TRUE(same_pose(reading.pose, readings[i].pose) && reading.age == readings[i].age) << "at " << time << " s";
            ++i;
        });
    });
}

void limits_are_positive(const Descriptor& plugin, const Case& with) {
    with_device(plugin, with, [](HapticDevice& device) {
        const DeviceLimits limits = device.limits();
        for (const double limit :
             {limits.force, limits.moment, limits.force_rate, limits.soft_start, limits.stale_after, limits.ramp_down}) {
            EXPECT_TRUE(std::isfinite(limit) && limit > 0.0) << limit;
        }
        EXPECT_GE(device.duration(), 0.0);
    });
}

void a_tick_allocates_nothing(const Descriptor& plugin, const Case& with) {
    with_device(plugin, with, [&](HapticDevice& device) {
        const std::size_t before = allocations();
        live(device, with, [](const Reading&, double) {});
        EXPECT_EQ(allocations() - before, 0U);
    });
}

}    // namespace

std::vector<Check> device_checks() {
    return {{"ReadingsAreFiniteAndUnit", readings_are_finite_and_unit},
            {"TheSameLifeIsLivedTwice", the_same_life_is_lived_twice},
            {"LimitsArePositive", limits_are_positive},
            {"ATickAllocatesNothing", a_tick_allocates_nothing}};
}

}    // namespace stylet::contract
