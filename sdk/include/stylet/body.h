// A body: needle and tissue answer the same questions. Within a tick core asks, in this order,
//
//     predict → (linearise → try_step), as often as it takes → commit or rollback
//
// λ is the force on the needle; the tissue is handed −λ, so a body always sees the forces that act on itself.
#pragma once

#include <stylet/plugin.h>
#include <stylet/types.h>

#include <span>

namespace stylet {

/// A place where needle and tissue meet. The tip is a point; a shaft contact stands for a piece of the track that the tip cut.
/// Core keeps the order of contacts from tick to tick and appends new ones, so a body may keep what it worked out for a point.
struct ContactPoint {
    Vector3 material;    // [m] undeformed position in the tissue; of a shaft contact, where its piece of track begins
    Vector3
        span;    // [m] the covered piece of track runs from `material` to `material + span`; grows with the tip; zero for the tip
    double arclength;    // [m] the needle's material there, from the base
    bool tip;
};

using ContactPoints = std::span<const ContactPoint>;

/// Core never asks about more contacts than this, so that a body can set its memory aside when it is made.
inline constexpr int max_contacts = 128;

using Forces = Eigen::Map<const VectorX>;    // 3n, [N], xyz of each contact

/// Where n contact points would be without contact forces, and how far each moves for a newton at each other, about the latest
/// trial state. The views live in the body and hold until its next call.
struct Linearisation {
    Eigen::Map<const VectorX> free;    // 3n, [m], world
    Eigen::Map<const MatrixX, Eigen::Unaligned, Eigen::OuterStride<>>
        compliance;       // 3n × 3n, [m/N], symmetric, may be indefinite
    int negatives = 0;    // negative eigenvalues of the body's own tangent
};

/// What a trial step left undone.
struct StepReport {
    double residual = 0.0;    // [N] largest force imbalance in the trial state; none once a body that solves to an accuracy which
                              // its scene states is within it: what that leaves shows in the energy books
    bool tangent_changed =
        false;    // the linearisation just used belongs to another branch: linearise again, whatever the residual
};

/// Energies of the latest trial state [J]; `damping` and `numerical` are totals since the start. They may swing within a cycle
/// (the trapezoid's share of a vibration), but over one they never fall.
struct EnergyReport {
    double stored = 0.0;
    double kinetic = 0.0;
    double damping = 0.0;      // lost to declared physical damping
    double numerical = 0.0;    // lost to the integrator
};

class Body : public Object {
public:
    /// About the latest trial state; repeatable, commits nothing. `shift` τ ≥ 0 [1/s²] is added to the tangent as τM by a body
    /// with inertia until the step's branch is stable; one without may add anything definite of its own that grows with τ dt².
    [[nodiscard]] virtual Linearisation linearise(ContactPoints points, double shift) = 0;

    /// Takes these forces on this body's contact points as the new trial state.
    virtual StepReport try_step(ContactPoints points, Forces forces) = 0;

    virtual void commit() = 0;      // the trial state becomes the state
    virtual void rollback() = 0;    // back to the last commit, bit for bit

    [[nodiscard]] virtual EnergyReport energy() const = 0;
};

}    // namespace stylet
