#pragma once

#include <stylet/haptic_device.h>

#include <cstddef>
#include <optional>

namespace stylet::core {

/// In how many ticks each step of the chain acted.
struct ForceChainCounts {
    std::size_t fault = 0;    // after an answer that was not finite, or another fault
    std::size_t magnitude = 0;
    std::size_t slew = 0;
    std::size_t stale = 0;
    std::size_t soft_start = 0;
};

/// The last thing between a simulation and a hand, the same for every device, in this order:
///
///     not finite → zero, and a fault for good;   magnitude (the lower of device and scene);   slew;
///     stale → ramp to zero, latched until re-armed;   soft start
///
/// An answer is stale where the hand was lost, no equilibrium was found, or the answer before was held for too long. The last
/// good force then fades out, and once it is gone it comes back only after `rearm_after` without a stale answer, faded in as at
/// the start. No scene can switch a step off.
class ForceChain {
public:
    static constexpr double rearm_after = 0.1;    // [s] what was lost for long is trusted again only after a while

    /// `force_limit` [N] is the scene's own.
    ForceChain(const DeviceLimits& device, std::optional<double> force_limit);

    /// What may be written to the device for a step of `dt` [s].
    [[nodiscard]] Wrench limit(const Wrench& asked, bool stale, double dt);

    /// Instead of limit(), once the simulation is over: the last good answer fades out.
    [[nodiscard]] Wrench let_go(double dt);

    /// From now on the force fades to zero and stays there.
    void trip() { faulted_ = true; }

    [[nodiscard]] bool faulted() const { return faulted_; }
    [[nodiscard]] bool holds() const { return level_ > 0.0 && !(last_.force.isZero(0.0) && last_.moment.isZero(0.0)); }
    [[nodiscard]] bool latched() const { return latched_; }    // the force is gone, and waits to be re-armed
    [[nodiscard]] const ForceChainCounts& counts() const { return counts_; }

private:
    void shorten(Wrench& wrench);
    void slew(Wrench& wrench, double dt);
    void fade(bool stale, double dt);

    DeviceLimits limits_;
    double moment_rate_;      // [N·m/s] as the device slews its own full force
    Wrench last_;             // the last good answer, before it is faded
    double level_ = 0.0;      // from 0 to 1: how much of it the hand is given
    double trusted_ = 0.0;    // [s] since the last stale answer
    bool latched_ = false;
    bool faulted_ = false;
    ForceChainCounts counts_;
};

}    // namespace stylet::core
