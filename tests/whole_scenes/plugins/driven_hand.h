// A hand that a test moves: the test finds it in the cast and gives it a motion before the first tick.
#pragma once

#include <stylet/haptic_device.h>

#include <algorithm>
#include <functional>

namespace stylet::whole_scenes {

class DrivenHand final : public HapticDevice {
public:
    static constexpr DeviceLimits device_limits{
        .force = 5.0, .moment = 0.5, .force_rate = 500.0, .soft_start = 0.01, .stale_after = 0.002, .ramp_down = 0.02};

    explicit DrivenHand(const Setup&) {}

    DeviceLimits limits() const override { return device_limits; }
    Reading read(double time) override {
        return {.pose = motion ? motion(time) : Pose{.position = {0.0, 0.0, 1.0}}, .age = age ? age(time) : 0.0};
    }
    void write(const Wrench& wrench) override {
        last = wrench;
        greatest_force = std::max(greatest_force, wrench.force.norm());
    }
    double duration() const override { return 1.0; }

    std::function<Pose(double time)> motion;
    std::function<double(double time)> age;    // [s]
    Wrench last;
    double greatest_force = 0.0;    // [N]
};

}    // namespace stylet::whole_scenes
