#pragma once

#include <stylet/plugin.h>
#include <stylet/types.h>

namespace stylet {

/// What the device can bear; all positive and finite. Core never writes more force or moment. The simulation's answer is slewed
/// to `force_rate` before it is faded in or out, so a fade adds its own slope; a fault may take the force away at once.
struct DeviceLimits {
    double force;          // [N] largest magnitude
    double moment;         // [N·m] largest magnitude
    double force_rate;     // [N/s] largest change; the moment is slewed in the same proportion
    double soft_start;     // [s] over which the force fades in
    double stale_after;    // [s] a reading older than this is one of a hand that was lost
    double ramp_down;      // [s] over which the force then fades out
};

/// What a device knows of the hand.
struct Reading {
    Pose pose;           // of the needle's base
    double age = 0.0;    // [s] how long ago it was measured; of a device that has lost its hand, ever more
};

/// A hand on the base. When a scene is over core fades the force out before it destroys the device; a device that is destroyed
/// while it still holds a force must let it go itself. Tells where it is, takes the wrench that core has limited.
class HapticDevice : public Object {
public:
    static constexpr Role role = Role::device;

    [[nodiscard]] virtual DeviceLimits limits() const = 0;

    /// The hand at `time` [s]. Core asks at time 0 first and then for times that rise by the scene's time step.
    [[nodiscard]] virtual Reading read(double time) = 0;

    /// What the hand shall feel until it is told otherwise, already limited.
    virtual void write(const Wrench& wrench) = 0;

    /// When a recorded motion ends [s]; infinite for a live hand.
    [[nodiscard]] virtual double duration() const { return std::numeric_limits<double>::infinity(); }
};

}    // namespace stylet
