#pragma once

#include <stylet/hand_motion.h>
#include <stylet/haptic_device.h>

#include <vector>

namespace stylet::mock {

/// A hand on its device, the same along x, y and z.
struct Constants {
    double mass;                // [kg] of device and hand together
    double device_damping;      // [N·s/m]
    double coulomb_friction;    // [N] of the device
    double position_quantum;    // [m] in which the device measures; 0: exactly
    double hand_damping;        // [N·s/m]
    double hand_stiffness;      // [N/m]
};

/// What a mass on spring and damper does in a substep: (x, x') becomes state · (x, x') + force · F, with F held throughout.
struct Transition {
    Eigen::Matrix2d state;
    Eigen::Vector2d force;    // [m/N], [m/(s·N)]
};

/// A simulated hand that holds a simulated haptic device, so that force feeds back on motion. Along each of x, y and z:
///
///     (m_device + m_hand) x'' = −b_device x' − f + k_hand (x_wanted − x) + b_hand (x_wanted' − x') + F
///
/// F is the last written force, held until the next. f is the device's Coulomb friction: F_c sgn x' while it moves, whatever up
/// to F_c keeps it at rest while it rests. x_wanted is the motion that the scene writes, straight within a tick. Read is x in
/// whole quanta.
///
/// All but the friction is integrated exactly, by a matrix exponential, so any time step will do. The friction is held over a
/// substep, the sixteenth of a tick: it is the one within ±F_c that brings the end of the substep as near to rest as can be
/// (Moreau 1988), so that what sticks is at rest.
///
/// Source: Colgate and Schenkel 1997 for the mass behind a zero-order hold; Abbott and Okamura 2005 for friction and quantum. We
/// add a hand that wants to be somewhere. Leaves out moments (the needle is turned as the motion says, whatever it feels), and
/// what makes a real device differ from axis to axis: its joints.
class Mock final : public HapticDevice {
public:
    explicit Mock(const Setup& setup);

    DeviceLimits limits() const override;
    Reading read(double time) override;
    void write(const Wrench& wrench) override { written_ = wrench.force; }
    double duration() const override { return wanted_.end(); }

private:
    void advance();

    double dt_;    // [s]
    PosePath wanted_;
    Constants constants_;
    Transition substep_;

    std::size_t ticks_ = 0;                 // lived so far
    Pose target_;                           // wanted at the last tick
    Vector3 position_;                      // [m] true, not measured
    Vector3 velocity_ = Vector3::Zero();    // [m/s]
    Vector3 written_ = Vector3::Zero();     // [N]
    std::vector<Vector3> late_;             // [N] what was written in the last ticks, one more than the delay, in a ring
};

}    // namespace stylet::mock
