#pragma once

#include <stylet/needle_model.h>

#include <limits>

namespace stylet::rigid {

/// A needle that does not deform: the hand drives every contact directly.
///
///     x(s) = base + s·axis,   compliance 0,   base wrench = −Σ(fᵢ, (xᵢ − base) × fᵢ)
///
/// Source: Newton's and Euler's balance of a massless rigid body.
/// Valid while the compression stays well below the critical load of the real needle and the side forces bend it by less than
/// what matters. Leaves out bending, buckling, stretching, twisting, inertia and weight; stores no energy.
class RigidNeedle final : public NeedleModel {
public:
    explicit RigidNeedle(const Setup& setup);

    void predict(const Pose& base, double free_length, double dt) override;
    Linearisation linearise(ContactPoints points, double shift) override;
    StepReport try_step(ContactPoints points, Forces forces) override;
    void commit() override { state_ = trial_; }
    void rollback() override { trial_ = state_; }
    EnergyReport energy() const override { return {}; }

    Vector3 position(double arclength) const override { return trial_.base.position + arclength * trial_.axis; }
    Vector3 tangent(double) const override { return trial_.axis; }
    Wrench base_wrench() const override { return {-state_.force, -state_.moment}; }
    NeedleState state() const override;
    void centreline(std::span<Vector3> points) const override;

private:
    struct State {
        Pose base;
        Vector3 axis = Vector3(0.0, 0.0, -1.0);    // unit, toward the tip
        Vector3 force = Vector3::Zero();           // [N] sum of the contact forces
        Vector3 moment = Vector3::Zero();          // [N·m] theirs about the base
    };

    double length_;    // [m]
    State state_;      // of the last commit
    State trial_;
    VectorX free_ = VectorX::Zero(3 * max_contacts);         // [m]
    VectorX no_motion_ = VectorX::Zero(3 * max_contacts);    // [m/N] every column of the compliance
};

}    // namespace stylet::rigid
