// A needle that bends, twists and stretches by itself: buckling, layers and steering come out of it without a formula.
#pragma once

#include "chain.h"
#include "spot.h"

#include <stylet/needle_model.h>

namespace stylet::rod {

/// A chain (chain.h) with the masses of its nodes, held at the base, loaded at contact points, by backward Euler:
///
///     M (x − x̃)/dt² + ∇U(x) = Jᵀ λ      x̃ = xₙ + dt vₙ
///
/// It lives in the frame of its base, so a hand that moves strains nothing by itself; the masses feel that the frame has moved.
/// Where core solves again at the same instant (dt = 0), the step is taken again from where it began: nothing creeps, and a
/// rupture within a tick has the tick's inertia.
///
/// `numerical` is exactly what the integrator takes: the trapezoid work on masses and edges less the change of their energies.
/// `buckled` is an observation: the free length bows by more than a hundredth of itself (until it is less than half of that)
/// under more than Euler's load of a clamped-free one. Source: Bergou et al. 2008, 2010; backward Euler as Baraff and Witkin
/// 1998.
class Rod final : public NeedleModel {
public:
    explicit Rod(const Setup& setup);

    void predict(const Pose& base, double free_length, double dt) override;
    Linearisation linearise(ContactPoints points, double shift) override;
    StepReport try_step(ContactPoints points, Forces forces) override;
    void commit() override;
    void rollback() override { trial_ = state_; }
    EnergyReport energy() const override;

    Vector3 position(double arclength) const override { return place(trial_, Spot::at(chain_, arclength), arclength); }
    Vector3 tangent(double arclength) const override;
    Vector3 cut_direction(double length) const override;
    Wrench base_wrench() const override { return state_.wrench; }
    NeedleState state() const override;
    void centreline(std::span<Vector3> points) const override;
    const char* beyond_validity() const override;

private:
    /// What a commit keeps.
    struct State {
        Pose base;
        double free_length = 0.0;    // [m]
        Shape shape;
        std::vector<double> tensions;     // [N] of each edge, as the last linear solve found them
        double dt = 0.0;                  // [s] of the step
        bool placed = false;              // anything was ever committed
        std::vector<Vector3> start;       // [m] world, the nodes when the step began
        std::vector<Vector3> coasting;    // [m] world, x̃
        std::vector<Strain> strains;      // of the joints when the step began
        Vector3 contact_force = Vector3::Zero(), contact_moment = Vector3::Zero();    // [N], [N·m] about the base
        Wrench wrench;                                                                // about the base
        bool buckled = false;

        // The books at the last commit.
        std::vector<Vector3> places;     // [m] world
        std::vector<Vector3> inertia;    // [N] m (x − x̃)/dt²
        std::vector<Strain> bent;        // of the joints
        std::vector<Vector3> viscous;    // [N·m] of the joints
        VectorX elastic;                 // ∇U of the shape, [N] and [N·m]
        EnergyReport energy;
    };

    void lay(Shape& shape) const;
    [[nodiscard]] Vector3 place(const State& state, int node) const;
    [[nodiscard]] Vector3 place(const State& state, const Spot& spot, double arclength) const;
    [[nodiscard]] Vector3 inertia(const State& state, int node) const;
    [[nodiscard]] double kinetic(const State& state) const;
    [[nodiscard]] Viscosity viscosity() const;
    [[nodiscard]] Vector3 viscous(int joint, const Strain& strain) const;
    [[nodiscard]] double node_mass(int node) const;
    [[nodiscard]] double bow(const State& state) const;
    void add_inertia(VectorX& imbalance) const;
    void add_contacts(ContactPoints points, Forces forces, VectorX& load) const;
    double advance(ContactPoints points, Forces forces);
    void add_up(ContactPoints points, Forces forces);
    double left_over(ContactPoints points, Forces forces);
    [[nodiscard]] double rounding() const;
    void find_spots(ContactPoints points);
    void solve_columns(int count);
    void assemble(ContactPoints points);

    NeedleSetup needle_;
    Chain chain_;
    double edge_mass_;      // [kg]
    double retardation_;    // [s]
    double cut_angle_;      // [rad] between the axis of the tip and the way that it cuts
    State trial_, state_;

    BandLdlt tangent_;
    VectorX imbalance_;          // ∇U + M(x − x̃)/dt², [N] and [N·m]
    VectorX step_;               // −tangent⁻¹ imbalance
    VectorX change_;             // of x in a step
    Columns columns_;            // tangent⁻¹ Jᵀ
    std::vector<int> starts_;    // of the columns
    std::vector<int> order_;     // the contacts from the base to the tip
    std::vector<Spot> spots_;    // of the contacts
    VectorX free_;               // 3n, [m]
    MatrixX compliance_;         // 3n × 3n, [m/N]
};

}    // namespace stylet::rod
