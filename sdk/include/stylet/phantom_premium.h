#pragma once

#include <stylet/haptic_device.h>

namespace stylet {

/// What a Phantom Premium 1.5 with six degrees of freedom bears, the device of He, Chen and Tang: whatever stands in for it is
/// limited like it.
inline constexpr DeviceLimits phantom_premium{
    .force = 8.5,           // its largest force
    .moment = 0.515,        // its largest torque in yaw and pitch, quoted from memory: check before it drives a motor
    .force_rate = 800.0,    // the stiffest wall it shows (0.8 N/mm) met at 1 m/s; insertions peak at 0.3 m/s
    .soft_start = 0.2,      // the time that a person needs to answer a force
    .stale_after = 5e-3,    // five readings of a loop at 1 kHz
    .ramp_down = 0.02,      // too fast to push with, too slow to be a kick
};

}    // namespace stylet
