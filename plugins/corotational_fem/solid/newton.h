// The reference: double precision, the exact forces, a factorised tangent.
#pragma once

#include "solid/solid.h"
#include "solver.h"

#include <Eigen/SparseCholesky>

#include <iostream>    // that MetisSupport forgets

#include <Eigen/MetisSupport>

namespace stylet::corotational_fem {

/// Newton's method on r(u) = w + f + Jᵀλ − ∂Ψ/∂u − M (u − ũ)/dt² = 0, to Coupling's own tolerance or what rounding leaves of it:
/// weight w, loads f, forces λ on footprints J, and ũ = uₙ + dt vₙ where there is inertia (backward Euler).
///
/// A step is u += A⁻¹r with A = K + M/dt² and the damper's τ/dt C, factorised about some earlier u, and halved until the step's
/// potential falls, so that it can't diverge. A is factorised anew where a step takes away less than nine tenths of the residual.
/// To factorise takes from milliseconds to seconds and allocates: this is the model to compare with, not the one to hold in a
/// hand.
class Newton final : public Solver {
public:
    static constexpr double tolerance = 1e-9;    // [N] largest imbalance of a node: Coupling's own

    /// `mesh` and `materials` must outlive it. Throws Error where the mesh is held too little or a density is missing.
    Newton(const Mesh& mesh, std::span<const Material> materials, const Motion& motion);

    void load(std::span<const NodeForce> forces) override;
    void place(int contact, std::span<const NodeWeight> footprint) override;
    void predict(double dt) override;
    void linearise(int contacts, Eigen::Ref<VectorX> free, Eigen::Ref<MatrixX, 0, Eigen::OuterStride<>> compliance) override;
    StepReport try_step(Forces forces) override;
    void commit() override;
    void rollback() override;
    EnergyReport energy() const override;
    Vector3 displacement(int node) const override { return trial_.u.segment<3>(3 * node); }

    bool inverted() const override { return solid_.inverted(); }

    [[nodiscard]] int factorisations() const { return factorisations_; }

private:
    struct State {
        VectorX u;                   // 3n, [m]
        VectorX start, coasting;     // 3n, [m] uₙ and ũ of the step
        VectorX loads;               // 3n, [N] f
        VectorX inner;               // 3n, [N] ∂Ψ/∂u + damping + M a: what the forces from outside are in balance with
        VectorX about;               // 3n, [m] displacements that the factor is of
        VectorX contact_forces;      // 3 max_contacts, [N] λ
        double factor_step = 0.0;    // [s] step that the factor is of
        double dt = 0.0;             // [s] of the step, zero before the first
        double elastic = 0.0;        // [J]
        double kinetic = 0.0;        // [J]
        double damping = 0.0;        // [J] since the beginning
        double numerical = 0.0;      // [J] since the beginning
    };
    struct Placed {
        std::vector<NodeWeight> footprint;
        bool answered = false;    // its columns of moved_ and compliance_ belong to the factor that there is
    };

    void evaluate();
    void keep_books(const VectorX& damping_forces);
    void balance();
    void factorise(const VectorX& u, double dt);
    bool factorise(double dt, Twists twists);
    void solve(const VectorX& forces, VectorX& displacements);
    void answer(int contact);
    void take_forces(const Forces& forces);
    [[nodiscard]] auto column(int contact, int direction) { return moved_.col(3 * contact + direction); }
    [[nodiscard]] static Vector3 mean(const Placed& placed, const VectorX& u);
    [[nodiscard]] double imbalance() const;      // [N]
    [[nodiscard]] double step_length() const;    // [s] that the step in hand takes its inertia and damping from
    [[nodiscard]] bool weighs() const { return !motion_.implicit || trial_.dt > 0.0; }

    Solid solid_;
    Motion motion_;
    double accuracy_;    // [N] tolerance, or more where a layer is so stiff that rounding leaves more
    Tangent tangent_;
    VectorX mass_;      // 3n, [kg]; empty without weight and inertia
    VectorX weight_;    // 3n, [N]
    VectorX load_;      // 3n, [N] from the next predict on
    Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Lower, Eigen::MetisOrdering<int>> factor_;
    VectorX diagonal_;             // 3n, [N/m] D of it
    VectorX about_;                // 3n, [m] displacements that it is of
    double factor_step_ = -1.0;    // [s] step_length() of the factor
    bool stale_ = true;            // the factor is of no use any more
    int factorisations_ = 0;

    std::vector<Placed> placed_;
    int contacts_ = 0;                              // the first so many are acted on
    MatrixX moved_;                                 // 3n × 3 max_contacts, [m/N] A⁻¹Jᵀ
    MatrixX compliance_;                            // of the contacts, [m/N]
    double potential_ = 0.0;                        // [J] of the trial state, but for the outer forces
    VectorX residual_;                              // 3n, [N] of the trial state, zero where held
    VectorX pressed_;                               // 3n, [N] Jᵀλ
    VectorX ahead_;                                 // 3n, [m] A⁻¹r
    VectorX before_, damping_forces_, permuted_;    // scratch
    State trial_, state_, origin_;                  // origin_: where this step's books begin
};

}    // namespace stylet::corotational_fem
