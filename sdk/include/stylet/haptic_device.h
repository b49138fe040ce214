#pragma once

#include <stylet/plugin.h>
#include <stylet/types.h>

namespace stylet {

/// What the device can bear. Core never writes more.
struct DeviceLimits {
    double force;         // [N] largest magnitude
    double moment;        // [N·m] largest magnitude
    double force_rate;    // [N/s] largest change; the moment is slewed in the same proportion
    double soft_start;    // [s] over which the force fades in
};

/// A hand on the base: gives poses, takes the wrench that core has limited.
class HapticDevice : public Object {
public:
    static constexpr Role role = Role::device;

    [[nodiscard]] virtual DeviceLimits limits() const = 0;

    /// The base's pose at `time` [s]; never falls behind it, may be asked for any time.
    [[nodiscard]] virtual Pose pose(double time) = 0;

    /// What the hand shall feel, already limited.
    virtual void write(const Wrench& wrench) = 0;

    /// When a recorded motion ends [s]; infinite for a live hand.
    [[nodiscard]] virtual double duration() const { return std::numeric_limits<double>::infinity(); }
};

}    // namespace stylet
