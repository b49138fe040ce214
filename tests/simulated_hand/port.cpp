#include "tests/simulated_hand/port.h"

#include <algorithm>
#include <cmath>

namespace stylet::simulated_hand {

Port port_of(const whole_scenes::Trace& trace, const Grip& grip, double dt) {
    const auto& samples = trace.samples;
    const auto delay = static_cast<std::size_t>(grip.delay);
    Port port;
    for (std::size_t k = 1; k < samples.size(); ++k) {
        const double moved = samples[k].travel - samples[k - 1].travel;
        const double felt = k > delay ? samples[k - 1 - delay].device_force : 0.0;
        port.given += felt * moved;
        port.held += 0.5 * (samples[k].device_force - samples[k - 1].device_force) * moved;
        port.lost += grip.device_damping * moved * moved / dt + grip.coulomb_friction * std::abs(moved);
        port.least_given = std::min(port.least_given, port.given);
        port.least_of_simulation = std::min(port.least_of_simulation, port.given + port.held);
        port.least_felt = std::min(port.least_felt, port.given + port.lost);
    }
    return port;
}

std::vector<double> device_forces(const whole_scenes::Trace& trace) {
    std::vector<double> forces;
    for (const core::Sample& sample : trace.samples) forces.push_back(sample.device_force);
    return forces;
}

}    // namespace stylet::simulated_hand
