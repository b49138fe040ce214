#include "checks.h"

#include <stylet/contract/allocations.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace stylet::contract {
namespace {

constexpr double unit = 1e-12;    // a normalised quaternion's length is off by roundings only

/// Times before, within and after a recorded motion, or the first seconds of a live hand [s].
std::vector<double> times_of(const HapticDevice& device) {
    const double end = std::isfinite(device.duration()) ? device.duration() : 10.0;
    std::vector<double> times{-1.0, 0.0, 1e-300, 1e9, end, std::nextafter(end, 0.0)};
    for (int i = 1; i < 200; ++i) times.push_back(end * i / 200.0);
    return times;
}

bool same_pose(const Pose& a, const Pose& b) {
    return std::memcmp(a.position.data(), b.position.data(), 3 * sizeof(double)) == 0 &&
           std::memcmp(a.rotation.coeffs().data(), b.rotation.coeffs().data(), 4 * sizeof(double)) == 0;
}

template <class Function>
void with_device(const Descriptor& plugin, const Case& with, Function check) {
    const auto object = make(plugin, with);
    check(static_cast<HapticDevice&>(*object));
}

void poses_are_finite_and_unit(const Descriptor& plugin, const Case& with) {
    with_device(plugin, with, [](HapticDevice& device) {
        for (const double time : times_of(device)) {
            const Pose pose = device.pose(time);
            EXPECT_TRUE(pose.finite()) << "at " << time << " s";
            EXPECT_NEAR(pose.rotation.norm(), 1.0, unit) << "at " << time << " s";
        }
    });
}

void a_recorded_time_has_one_pose(const Descriptor& plugin, const Case& with) {
    with_device(plugin, with, [&](HapticDevice& device) {
        if (!std::isfinite(device.duration())) return;    // a live hand answers for now only
        const auto other = make(plugin, with);
        auto& backwards = static_cast<HapticDevice&>(*other);
        std::vector<double> times = times_of(device);
        std::vector<Pose> poses;
        for (const double time : times) poses.push_back(device.pose(time));
        for (std::size_t i = times.size(); i-- > 0;)
            EXPECT_TRUE(same_pose(backwards.pose(times[i]), poses[i])) << "at " << times[i] << " s";
    });
}

void the_last_pose_is_held(const Descriptor& plugin, const Case& with) {
    with_device(plugin, with, [](HapticDevice& device) {
        if (!std::isfinite(device.duration())) return;
        EXPECT_TRUE(same_pose(device.pose(device.duration()), device.pose(device.duration() + 100.0)));
    });
}

void limits_are_positive(const Descriptor& plugin, const Case& with) {
    with_device(plugin, with, [](HapticDevice& device) {
        const DeviceLimits limits = device.limits();
        for (const double limit : {limits.force, limits.moment, limits.force_rate, limits.soft_start}) {
            EXPECT_TRUE(std::isfinite(limit) && limit > 0.0) << limit;
        }
        EXPECT_GE(device.duration(), 0.0);
    });
}

void a_tick_allocates_nothing(const Descriptor& plugin, const Case& with) {
    with_device(plugin, with, [](HapticDevice& device) {
        const std::vector<double> times = times_of(device);
        const std::size_t before = allocations();
        for (const double time : times) {
            (void)device.pose(time);
            device.write({Vector3(0.1, -0.2, 0.3), Vector3(0.01, 0.02, -0.03)});
        }
        EXPECT_EQ(allocations() - before, 0U);
    });
}

}    // namespace

std::vector<Check> device_checks() {
    return {{"PosesAreFiniteAndUnit", poses_are_finite_and_unit},
            {"ARecordedTimeHasOnePose", a_recorded_time_has_one_pose},
            {"TheLastPoseIsHeld", the_last_pose_is_held},
            {"LimitsArePositive", limits_are_positive},
            {"ATickAllocatesNothing", a_tick_allocates_nothing}};
}

}    // namespace stylet::contract
