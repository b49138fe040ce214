// What passes between hand and simulation, told from a trace of a needle that is held along its axis.
#pragma once

#include "tests/simulated_hand/grips.h"

namespace stylet::simulated_hand {

/// Energies [J] at the port, and the least that each sum came to on the way (at most 0). With F_k the compression written at tick
/// k and x_k the base's way along the needle:
///
///     given  Σ F_k−1−delay (x_k − x_k−1)
///     held   ½ Σ (F_k − F_k−1)(x_k − x_k−1)
///     lost   Σ b (x_k − x_k−1)²/dt + F_c |x_k − x_k−1|
///
/// `given`, from hand to simulation, is the passivity observer (Hannaford and Ryu 2002); `held` is what a force that is held
/// between ticks gives back too much: with it, `given` is the trapezoid's work, the simulation's own. `lost` is in the device, at
/// least: the square of the mean speed is no more than the mean square.
struct Port {
    double given = 0.0, held = 0.0, lost = 0.0;
    double least_given = 0.0;
    double least_of_simulation = 0.0;    // of given + held, without delay
    double least_felt = 0.0;             // of given + lost: what the hand itself has to do with
};

/// `dt` [s] is the scene's time step.
[[nodiscard]] Port port_of(const whole_scenes::Trace& trace, const Grip& grip, double dt);

/// The device's force after each tick [N].
[[nodiscard]] std::vector<double> device_forces(const whole_scenes::Trace& trace);

}    // namespace stylet::simulated_hand
