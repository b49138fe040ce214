// The fast solver: single precision, a factor of the undeformed mesh, and what the last steps have taught about the deformed one.
#pragma once

#include "fast/element_forces.h"
#include "fast/lbfgs.h"
#include "fast/panels.h"
#include "fast/quasi_newton_contacts.h"
#include "solver.h"

#include <memory>

namespace stylet::corotational_fem {

/// A quasi-Newton method on the same equations as Newton (solid/newton.h),
///
///     r(u) = w + f + Jᵀλ − ∂Ψ/∂u − M (u − ũ)/dt² = 0,
///
/// with the true nonlinear residual. An iteration goes to u + H r, where H is the inverse of the undeformed mesh's matrix for
/// Motion::dt with the last three pairs of step and change of force worked in (Lbfgs); the pairs stay from one time step to the
/// next. A time step begins where the last one ended: its pair says how stiff the tissue is in the direction in which it moves,
/// so that nothing is gained by going ahead with its inertia first. A step that overshoots, or that doesn't lower the potential,
/// is shortened until it does, so that it can't diverge.
///
/// Each iteration is one solve and one pass over the tetrahedra, which gives the residual where it ends: most time steps are one
/// iteration. The state counts as in balance once the error that is left, the last step times how much is left of the residual or
/// of the steps, is below `accuracy` of the displacements, all in the Euclidean norm over all nodes. For contacts W = J A⁻¹ Jᵀ is
/// that of the undeformed mesh: within some percent of the deformed one's where tetrahedra turn by 10°.
///
/// Accuracy: displacements to about `accuracy` a time step, at best 1e-5, for single precision ends there. Steps of another
/// length than Motion::dt are about as accurate and take more iterations: 5 at half of it, up to 50 at ten times, hundreds at a
/// hundred times.
///
/// Source: Nocedal 1980; Liu, Bouaziz and Kavan 2017, who precondition L-BFGS with a constant factor. Deviation: theirs is a
/// scalar Laplacian a coordinate, which a Poisson ratio near 0.5 makes slow; ours is the stiffness itself.
class QuasiNewton final : public Solver {
public:
    /// `accuracy` in [1e-5, 0.1]. `mesh`, `materials` and `workers` must outlive it. Throws Error where the mesh is held too
    /// little, a density is missing, or the machine has no room for the factor.
    QuasiNewton(const Mesh& mesh, std::span<const Material> materials, const Motion& motion, double accuracy, Workers& workers,
                InstructionSet set = best_instruction_set());

    void load(std::span<const NodeForce> forces) override;
    void place(int contact, std::span<const NodeWeight> footprint) override;
    void predict(double dt) override;
    void linearise(int contacts, Eigen::Ref<VectorX> free, Eigen::Ref<MatrixX, 0, Eigen::OuterStride<>> compliance) override;
    StepReport try_step(Forces forces) override;
    void commit() override;
    void rollback() override;
    EnergyReport energy() const override;
    Vector3 displacement(int node) const override;
    bool inverted() const override { return trial_.inverted; }

    [[nodiscard]] long long iterations() const { return iterations_; }    // since the beginning

private:
    struct alignas(32) Place {    // [m], in double precision: 10⁶ small steps add up
        double x, y, z, none;
    };
    struct State {
        std::vector<Place> from;                  // [m] displacements at the step's start
        NodalVector moved;                        // [m] since
        NodalVector coasting;                     // [m] how far it would have moved by inertia alone
        NodalVector inner;                        // [N] ∂Ψ/∂u and damping
        NodalVector loads;                        // [N] weight and loads on nodes
        std::vector<double> lambda;               // [N] of the contacts
        int contacts = 0;                         // that λ acts on
        double dt = 0.0;                          // [s] of the step, zero before the first
        double elastic = 0.0;                     // [J]
        double kinetic = 0.0;                     // [J]
        double weight = 0.0;                      // [J] its potential
        double weight_before = 0.0;               // [J] the same at the step's start
        double dissipated = 0.0;                  // [J] by damping, in this step
        double damping = 0.0, numerical = 0.0;    // [J] since the beginning
        bool inverted = false;
        bool settled = false;        // in balance, within the accuracy
        double contraction = 1.0;    // [1] of steps, as measured last
        double learnt_dt = 0.0;      // [s] that the pairs are for
    };
    struct Origin {               // of the books: where the latest predict found the tissue
        NodalVector moved;        // [m]
        NodalVector resisting;    // [N] inner forces and inertia
        double elastic = 0.0, kinetic = 0.0, dissipated = 0.0, damping = 0.0, numerical = 0.0;    // [J]
    };
    struct Step {                 // along ahead_
        double slope;             // [J] r·d, by which the potential falls to first order
        double squared;           // [m²] d·d
        double inner;             // [J] of the inner forces before it
        double inertia;           // [J] d·M d/dt²
        double elastic;           // [J] before it, half of what damping takes counted
        double residual;          // [√J] its size before it
        double fraction = 1.0;    // [1] of ahead_ that has been gone
        double along = 0.0;       // [J] r·d where it ends
    };

    QuasiNewton(const Mesh& mesh, std::span<const Material> materials, const Motion& motion, double accuracy, Workers& workers,
                InstructionSet set, const BlockMatrix& matrix);

    bool gather_loads();
    void set_forces(std::span<const double> lambda);
    void start_step(double dt);
    void start_damper(NodalVector& forces);
    void move(float fraction);
    void evaluate();
    double balance();
    void find_direction();
    void redirect(std::span<const double> lambda);
    void head_for(std::span<const double> lambda);
    void push(std::span<const double> lambda, NodalVector& answer);
    [[nodiscard]] Eigen::Ref<const VectorX> moved_by(std::span<const double> lambda);
    [[nodiscard]] bool same_to_accuracy(std::span<const double> lambda);
    [[nodiscard]] bool is_for_contacts(std::span<const double> lambda) const {
        return lambda.size() == static_cast<std::size_t>(3 * trial_.contacts);
    }
    bool iterate();
    [[nodiscard]] Step measure() const;
    void go(Step& step, double fraction);
    [[nodiscard]] double shortened(const Step& step) const;
    void learn(const Step& step);
    [[nodiscard]] bool enough(const Step& step);
    [[nodiscard]] bool enough_elsewhere(double length, bool measured) const;
    [[nodiscard]] auto resisting() const;
    void open_books();
    void close_books();
    [[nodiscard]] double step_length() const { return trial_.dt > 0.0 ? trial_.dt : motion_.dt; }
    [[nodiscard]] bool damped() const { return motion_.damping_time > 0.0; }
    [[nodiscard]] double answer_scale() const;    // [1] by which the factor's answers are taken
    [[nodiscard]] float inertia() const;          // [1/s²] 1/dt²
    [[nodiscard]] double imbalance() const;
    void foresee();
    [[nodiscard]] double astray();

    Motion motion_;
    double accuracy_;
    Workers& workers_;
    Dissection dissection_;
    std::unique_ptr<Panels> panels_;
    ElementForces elements_;
    Contacts contacts_;
    NodeLoops loops_;
    Lbfgs pairs_;
    int nodes_;                      // free ones
    std::vector<float> mass_;        // [kg]
    std::vector<float> softness_;    // [m/N] of each node with all others held
    NodalVector node_loads_;         // [N] as told last
    State trial_, state_;
    Origin origin_;
    NodalVector x_, start_;    // [m] displacements of the trial state and of the step's start, and the zero node's
    NodalVector outer_;        // [N] loads and contact forces
    bool outer_known_ = false;
    NodalVector residual_, before_, q_;    // [N] of the trial state, of the one before, and what the factor is asked
    double residual_size_ = 0.0;           // [√J] each node's by its stiffness
    VectorX foreseen_;                     // 3n, [m] displacements of the contacts that their forces were found for
    VectorX changed_, moved_;              // [N], [m] of contacts
    NodalVector answer_;                   // [m] of the factor alone to q_
    NodalVector ahead_;                    // [m] H r
    bool ahead_known_ = false;
    double size_ = 0.0;           // [m] of the displacements
    bool placed_anew_ = false;    // a contact, since the last commit
    bool polished_ = false;       // by an iteration since the last predict, and in balance
    bool rested_ = false;         // in balance as an iteration left it in this time step: since then only the clock has gone on
    double noise_ = 0.0;          // [m] steps shorter than this are single precision's
    double last_step_ = 0.0;      // [m] of this time step's iteration before, zero in the first
    long long iterations_ = 0;
};

}    // namespace stylet::corotational_fem
