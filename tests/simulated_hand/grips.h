// Which hand holds which device: put into any scene whose device is given a motion.
#pragma once

#include "tests/whole_scenes/trace.h"

#include <ostream>
#include <string>

namespace stylet::simulated_hand {

/// The constants of the mock. The reference's ranges: device mass 0.05 to 0.2 kg, its damping 0.005 to 1 N·s/m, Coulomb friction
/// 0.04 N, quantum 0.03 mm; hand mass 0.1 to 0.5 kg, its damping 2 to 10 N·s/m, its stiffness 100 to 1000 N/m.
struct Grip {
    std::string name;
    double device_mass;                   // [kg]
    double device_damping;                // [N·s/m]
    double hand_mass;                     // [kg]
    double hand_damping;                  // [N·s/m]
    double hand_stiffness;                // [N/m]
    double coulomb_friction = 0.04;       // [N]
    double position_quantum = 0.03e-3;    // [m]
    int delay = 0;                        // [ticks]

    friend std::ostream& operator<<(std::ostream& stream, const Grip& grip) { return stream << grip.name; }
};

/// The corners of those ranges, and the one that is swung the most easily.
inline const Grip grips[] = {{"SoftHandOnALightDevice", 0.05, 0.005, 0.1, 2.0, 100.0},
                             {"StiffHandOnALightDevice", 0.05, 0.005, 0.1, 10.0, 1000.0},
                             {"SoftHandOnAHeavyDevice", 0.2, 1.0, 0.5, 2.0, 100.0},
                             {"StiffHandOnAHeavyDevice", 0.2, 1.0, 0.5, 10.0, 1000.0},
                             {"LooseHandOnALightDevice", 0.05, 0.005, 0.1, 2.0, 1000.0}};

/// What makes a scene's recorded hand this one, which then wants to go the way that the recorded one went.
[[nodiscard]] whole_scenes::Overrides held_by(const Grip& grip);

}    // namespace stylet::simulated_hand
