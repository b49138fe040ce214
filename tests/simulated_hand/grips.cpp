#include "tests/simulated_hand/grips.h"

#include <cstdio>

namespace stylet::simulated_hand {

namespace {

std::string with_unit(double value, const char* unit) {
    char text[64];
    std::snprintf(text, sizeof text, "%.17g %s", value, unit);
    return text;
}

}    // namespace

whole_scenes::Overrides held_by(const Grip& grip) {
    whole_scenes::Overrides overrides{{"device.type", "mock"},
                                      {"device.device_mass", with_unit(grip.device_mass, "kg")},
                                      {"device.device_damping", with_unit(grip.device_damping, "N*s/m")},
                                      {"device.coulomb_friction", with_unit(grip.coulomb_friction, "N")},
                                      {"device.position_quantum", with_unit(grip.position_quantum, "m")},
                                      {"device.hand_mass", with_unit(grip.hand_mass, "kg")},
                                      {"device.hand_damping", with_unit(grip.hand_damping, "N*s/m")},
                                      {"device.hand_stiffness", with_unit(grip.hand_stiffness, "N/m")}};
    if (grip.delay > 0) overrides.push_back({"device.delay", std::to_string(grip.delay)});
    return overrides;
}

}    // namespace stylet::simulated_hand
