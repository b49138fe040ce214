#pragma once

#include <stylet/haptic_device.h>

#include <optional>

namespace stylet::core {

/// The last thing between a simulation and a hand, the same for every device, in this order: not finite → zero and a latched
/// fault; magnitude (the lower of device and scene); slew; soft start. No scene can switch a step off.
class ForceLimiter {
public:
    /// `force_limit` [N] is the scene's own.
    ForceLimiter(const DeviceLimits& device, std::optional<double> force_limit);

    /// What may be written to the device for a step of `dt` [s].
    [[nodiscard]] Wrench limit(const Wrench& asked, double dt);

    /// From now on the force goes to zero, however long it takes at the device's rate, and stays there.
    void trip() { faulted_ = true; }

    [[nodiscard]] bool faulted() const { return faulted_; }

private:
    DeviceLimits limits_;
    Wrench last_;             // before the soft start
    double running_ = 0.0;    // [s] since the start, for the soft start
    bool faulted_ = false;
};

}    // namespace stylet::core
