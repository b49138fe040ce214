#pragma once

#include <stylet/types.h>

#include <algorithm>

namespace stylet::core {

/// The energy that a hand has put into the simulation through a device that holds each wrench until the next:
///
///     E_n = −Σ_k  F_k·(x_{k+1} − x_k) + M_k·θ_k,   θ_k the turn from k to k + 1
///
/// with F, M what the hand feels. A simulation that is passive never gives back more than it got: E ≥ 0. Source: Hannaford and
/// Ryu 2002, Eq. (3), with poses instead of velocities, so that nothing is lost between two samples. Holding a force for a sample
/// gives back ½ΣΔF·Δx of its own, whatever the simulation: anything elastic that springs back goes below zero by that. Without
/// it, by the trapezoid rule, what is left is the simulation's doing.
class PassivityObserver {
public:
    /// The hand is here now, and felt the last written wrench on its way.
    void moved(const Pose& hand) {
        if (begun_) {
            const Eigen::AngleAxisd turn(hand.rotation * hand_.rotation.conjugate());
            way_ = hand.position - hand_.position;
            turn_ = turn.angle() * turn.axis();
            energy_ -= work(felt_);
            least_ = std::min(least_, energy_);
        }
        hand_ = hand;
        begun_ = true;
    }

    void wrote(const Wrench& felt) {
        without_hold_ -= 0.5 * (work(felt_) + work(felt));
        least_without_hold_ = std::min(least_without_hold_, without_hold_);
        felt_ = felt;
        way_.setZero();
        turn_.setZero();
    }

    [[nodiscard]] double energy() const { return energy_; }                            // [J]
    [[nodiscard]] double least() const { return least_; }                              // [J] so far, at most 0
    [[nodiscard]] double least_without_hold() const { return least_without_hold_; }    // [J] the same by the trapezoid rule

private:
    [[nodiscard]] double work(const Wrench& felt) const { return felt.force.dot(way_) + felt.moment.dot(turn_); }

    Vector3 way_ = Vector3::Zero();     // [m] since the last write
    Vector3 turn_ = Vector3::Zero();    // [rad]
    double without_hold_ = 0.0;         // [J]
    double least_without_hold_ = 0.0;
    Pose hand_;
    Wrench felt_;
    double energy_ = 0.0;
    double least_ = 0.0;
    bool begun_ = false;
};

}    // namespace stylet::core
