// A needle and a tissue for the coupling's tests: an elastic column that buckles by itself, and springs that hold contact points.
#pragma once

#include <stylet/needle_model.h>
#include <stylet/tissue_model.h>

namespace stylet::core {

struct ColumnSetup {
    double length;               // [m]
    double axial_stiffness;      // [N] EA
    double bending_stiffness;    // [N·m²] EI
    double line_density;         // [kg/m]
    double side_force;           // [N] constant, in the bow's direction, on the middle node: what makes the column imperfect
    int elements;
};

/// A discrete rod in the plane of the needle's axis and its bow: straight and equal elements that stretch (½ EA/ℓ (|e| − ℓ)²)
/// and hinges between them that bend (½ EI/ℓ θ², θ the turning angle; at the clamp half an element, EI/ℓ θ²). Gradient and
/// tangent are the exact derivatives, so that compression lowers the lateral stiffness. Lumped masses, backward Euler. The
/// unknowns are displacements from the straight needle on the base: positions would lose to rounding what the stretch of a steel
/// needle is made of. The base may move, not turn; a step of no time has no inertia.
class PlanarColumn final : public NeedleModel {
public:
    PlanarColumn(const ColumnSetup& setup, const Pose& base);

    void predict(const Pose& base, double free_length, double dt) override;
    Linearisation linearise(ContactPoints points, double shift) override;
    StepReport try_step(ContactPoints points, Forces forces) override;
    void commit() override;
    void rollback() override { trial_ = committed_; }

    [[nodiscard]] EnergyReport energy() const override { return trial_.energy; }
    [[nodiscard]] Vector3 position(double arclength) const override;
    [[nodiscard]] Vector3 tangent(double arclength) const override;
    [[nodiscard]] Wrench base_wrench() const override { return wrench_; }
    [[nodiscard]] NeedleState state() const override;
    void centreline(std::span<Vector3> points) const override;

    /// The tangent of the straight column under this compression [N], without inertia: 2n × 2n, [N/m], along and across each
    /// node.
    [[nodiscard]] MatrixX straight_tangent(double compression) const;

    [[nodiscard]] double bow() const;                                       // [m] of the trial state's middle node
    [[nodiscard]] int linearisations() const { return linearisations_; }    // since it was made

private:
    struct State {
        Pose base;
        VectorX displacement;    // 2n, [m], along and across of each node but the base's
        VectorX velocity;        // 2n, [m/s], of the world
        VectorX inertia;         // 2n, [N], mass times acceleration
        EnergyReport energy;
    };
    struct Elastic {
        double energy = 0.0;
        VectorX gradient;    // 2n, [N]
        MatrixX tangent;     // 2n × 2n, [N/m]
    };
    using Pair = Eigen::Vector2d;
    using Block = Eigen::Matrix2d;

    [[nodiscard]] Elastic elastic(const VectorX& displacement) const;
    [[nodiscard]] Pair node(const VectorX& displacement, int i) const;
    [[nodiscard]] VectorX carried() const;
    [[nodiscard]] VectorX inertia_forces(const VectorX& displacement) const;
    [[nodiscard]] VectorX imbalance(const VectorX& displacement) const;
    [[nodiscard]] Eigen::Matrix<double, 3, 2> directions() const;
    [[nodiscard]] MatrixX interpolation(ContactPoints points) const;
    [[nodiscard]] EnergyReport energy_of(const VectorX& displacement) const;

    ColumnSetup setup_;
    double element_;    // [m] length of one
    double mass_;       // [kg] of a node; half of it at the tip
    VectorX masses_;    // 2n
    State committed_, trial_;
    double dt_ = 0.0;    // [s] of this step
    Wrench wrench_;
    VectorX contact_forces_;    // 2n, of the trial state

    Eigen::PartialPivLU<MatrixX> solver_;    // of the latest linearisation
    int negatives_ = 0;                      // of its tangent without the shift
    int linearisations_ = 0;
    VectorX free_;          // 3 contacts
    MatrixX compliance_;    // 3 contacts × 3 contacts
};

/// Springs at the contact points that also feel each other: W_ij = w exp(−|i − j|), w of its own along each world axis [m/N].
class SpringTissue final : public TissueModel {
public:
    explicit SpringTissue(const Vector3& compliance) : springs_(compliance) {}

    void predict(double) override {}
    Linearisation linearise(ContactPoints points, double shift) override;
    StepReport try_step(ContactPoints points, Forces forces) override;
    void commit() override { committed_ = trial_; }
    void rollback() override { trial_ = committed_; }
    [[nodiscard]] EnergyReport energy() const override { return {.stored = trial_}; }
    [[nodiscard]] Vector3 displacement(const Vector3&) const override { return Vector3::Zero(); }
    [[nodiscard]] Location locate(const Vector3& material) const override;
    [[nodiscard]] double entry(const Vector3&, const Vector3&) const override { return -1.0; }

private:
    Vector3 springs_;
    double trial_ = 0.0, committed_ = 0.0;    // [J]
    VectorX free_;
    MatrixX compliance_;
};

}    // namespace stylet::core
