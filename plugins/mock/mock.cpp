#include "mock.h"

#include <stylet/phantom_premium.h>

#include <unsupported/Eigen/MatrixFunctions>

#include <cmath>
#include <cstdio>

namespace stylet::mock {
namespace {

constexpr int substeps = 16;    // of a tick; only friction depends on it
// [rad] that a hand may swing within a substep. Within half a swing a push is answered the way it goes, as friction takes for
// granted.
constexpr double most_swing = 1.0;

Constants read_constants(const Parameters& parameters) {
    return {.mass = parameters.number("device_mass") + parameters.number("hand_mass"),
            .device_damping = parameters.number("device_damping"),
            .coulomb_friction = parameters.number("coulomb_friction"),
            .position_quantum = parameters.number("position_quantum"),
            .hand_damping = parameters.number("hand_damping"),
            .hand_stiffness = parameters.number("hand_stiffness")};
}

// exp of the matrix of (x, x', F)' = (x', (F − b x' − k x)/m, 0)
Transition transition_of(const Constants& c, double h) {
    Matrix3 rate = Matrix3::Zero();
    rate(0, 1) = 1.0;
    rate.row(1) << -c.hand_stiffness / c.mass, -(c.device_damping + c.hand_damping) / c.mass, 1.0 / c.mass;
    const double swing = std::sqrt(c.hand_stiffness / c.mass) * h;    // [rad]
    if (!(swing <= most_swing)) {
        char text[160];
        std::snprintf(
            text, sizeof text,
            "found a hand that swings by %.3g rad within a time step, wanted at most %g: softer, heavier or a higher rate",
            swing * substeps, most_swing * substeps);
        throw Error("hand_stiffness", text);
    }
    const Matrix3 grown = (rate * h).exp();
    if (!grown.allFinite()) throw Error("device_mass", "found a mass too small for its damping, wanted a heavier device");
    return {grown.topLeftCorner<2, 2>(), grown.topRightCorner<2, 1>()};
}

Vector3 measured(const Vector3& position, double quantum) {
    if (quantum == 0.0) return position;
    return quantum * (position / quantum).array().round();
}

}    // namespace

Mock::Mock(const Setup& setup)
    : dt_(setup.dt),
      wanted_(read_motion(setup.parameters, setup.needle->length)),
      constants_(read_constants(setup.parameters)),
      substep_(transition_of(constants_, dt_ / substeps)),
      target_(wanted_.at(0.0)),
      position_(target_.position),
      late_(setup.parameters.has("delay") ? setup.parameters.integer("delay") + 1 : 1, Vector3::Zero()) {}

DeviceLimits Mock::limits() const {
    return phantom_premium;
}

Reading Mock::read(double time) {
    for (const auto now = static_cast<std::size_t>(std::llround(time / dt_)); ticks_ < now; ++ticks_) advance();
    return {.pose = {measured(position_, constants_.position_quantum), target_.rotation}};
}

// In the frame that goes with the wanted position the spring's end is at rest; there the device drags at −b_device x_wanted'.
void Mock::advance() {
    late_[ticks_ % late_.size()] = written_;
    const Vector3& force = late_[(ticks_ + 1) % late_.size()];
    const Vector3 from = target_.position;
    target_ = wanted_.at(static_cast<double>(ticks_ + 1) * dt_);
    const Vector3 speed = (target_.position - from) / dt_;
    const Vector3 push = force - constants_.device_damping * speed;
    const auto& [state, gain] = substep_;
    for (int i = 0; i < substeps; ++i) {
        const Vector3 offset = position_ - (from + speed * (i * dt_ / substeps));
        const Vector3 drift = velocity_ - speed;
        const Vector3 sliding = speed + state(1, 0) * offset + state(1, 1) * drift + gain(1) * push;    // without friction
        const Vector3 friction =
            (-sliding / gain(1)).cwiseMin(constants_.coulomb_friction).cwiseMax(-constants_.coulomb_friction);
        position_ =
            from + speed * ((i + 1) * dt_ / substeps) + state(0, 0) * offset + state(0, 1) * drift + gain(0) * (push + friction);
        velocity_ = sliding + gain(1) * friction;
    }
}

namespace {

constexpr Parameter parameters[] = {
    records("motion", motion_step, "where the hand wants to go: steps one after the other, each insert, withdraw or hold"),
    vector3("tip_start", "m", "where the tip is, at rest, at time 0"),
    motion_direction,
    motion_cycles,
    number("device_mass", "kg", positive, "what moves of the device; 0.05 to 0.2 kg is usual"),
    number("device_damping", "N*s/m", not_negative, "viscous, of the device; 0.005 to 1 N*s/m is usual"),
    number("coulomb_friction", "N", not_negative, "of the device along each axis; 0.04 N is usual"),
    number("position_quantum", "m", not_negative, "in which the device measures; 0.03 mm is usual, 0 measures exactly"),
    number("hand_mass", "kg", not_negative, "what moves of the hand; 0.1 to 0.5 kg is usual"),
    number("hand_damping", "N*s/m", not_negative, "with which the hand follows its wish; 2 to 10 N*s/m is usual"),
    number("hand_stiffness", "N/m", not_negative,
           "with which the hand holds on to its wish; 100 to 1000 N/m is usual, 0 lets the device go"),
    optional(integer("delay", {.least = 1, .greatest = 1000}, "ticks by which a force is felt too late; left out: none")),
};

}    // namespace
}    // namespace stylet::mock

STYLET_PLUGIN(stylet::mock::Mock, "mock", stylet::mock::parameters,
              .summary = "A simulated hand that holds a simulated haptic device and gives way to the force that it feels",
              .formula =
                  "(m_device + m_hand) x'' = -b_device x' - f + k_hand (x_wanted - x) + b_hand (x_wanted' - x') + F\n"
                  "f = F_c sgn x' while it moves, |f| <= F_c while it rests; x is read in whole quanta\n"
                  "x [m] along each of x, y and z, F [N] last force, held until the next, F_c [N] Coulomb friction, "
                  "x_wanted [m] the scene's motion",
              .source =
                  "Colgate and Schenkel 1997, the mass behind a zero-order hold; Abbott and Okamura 2005, friction and "
                  "quantum; Moreau 1988, time stepping with friction. Deviation: the hand wants to be somewhere. The limits "
                  "are those of a Phantom Premium 1.5",
              .validity =
                  "Small and slow motions, in which an arm is a spring, a damper and a mass. Leaves out moments: the needle "
                  "is turned as the motion says, whatever it feels. Leaves out joints: mass and friction are the same "
                  "along x, y and z")
