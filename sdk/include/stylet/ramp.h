// How a load that a scene prescribes comes on.
#pragma once

#include <stylet/parameters.h>

namespace stylet {

/// To be declared by every plugin that makes a Ramp of its parameters.
inline constexpr Parameter ramp_parameter =
    optional(number("ramp", "s", positive, "time over which the force grows linearly from nothing; left out: all of it at once"));

/// The share of a prescribed load that acts at time t: nothing up to time 0, then min(t/ramp, 1), or 1 where the scene gives no
/// `ramp`.
class Ramp {
public:
    explicit Ramp(const Parameters& parameters) : duration_(parameters.has("ramp") ? parameters.number("ramp") : 0.0) {}

    /// From 0 to 1, at `time` [s].
    [[nodiscard]] double share(double time) const {
        if (time <= 0.0) return 0.0;
        return time < duration_ ? time / duration_ : 1.0;
    }

private:
    double duration_;    // [s] zero for a step
};

}    // namespace stylet
