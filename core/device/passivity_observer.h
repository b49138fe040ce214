#pragma once

#include <stylet/types.h>

#include <algorithm>

namespace stylet::core {

/// The energy that a hand has put into the simulation through a device that holds each wrench until the next:
///
///     E_n = −Σ_k  F_k·(x_{k+1} − x_k) + M_k·θ_k,   θ_k the turn from k to k + 1
///
/// with F, M what the hand feels. A simulation that is passive never gives back more than it got: E ≥ 0. Source: Hannaford and
/// Ryu 2002, Eq. (3), with poses instead of velocities, so that nothing is lost between two samples.
class PassivityObserver {
public:
    /// The hand is here now, and felt the last written wrench on its way.
    void moved(const Pose& hand) {
        if (begun_) {
            const Eigen::AngleAxisd turn(hand.rotation * hand_.rotation.conjugate());
            energy_ -= felt_.force.dot(hand.position - hand_.position) + felt_.moment.dot(turn.angle() * turn.axis());
            least_ = std::min(least_, energy_);
        }
        hand_ = hand;
        begun_ = true;
    }

    void wrote(const Wrench& felt) { felt_ = felt; }

    [[nodiscard]] double energy() const { return energy_; }    // [J]
    [[nodiscard]] double least() const { return least_; }      // [J] so far, at most 0

private:
    Pose hand_;
    Wrench felt_;
    double energy_ = 0.0;
    double least_ = 0.0;
    bool begun_ = false;
};

}    // namespace stylet::core
