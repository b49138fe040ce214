// What the plugin asks of whatever solves its mesh.
#pragma once

#include "mesh/mesh.h"

#include <stylet/body.h>

#include <span>

namespace stylet::corotational_fem {

/// By how much a node takes part in a footprint. The weights of one footprint add up to one; a fixed node takes part without
/// moving.
struct NodeWeight {
    int node;    // of the mesh
    double weight;
};

struct NodeForce {
    int node;         // of the mesh
    Vector3 force;    // [N]
};

/// What a scene says about the motion, the same for every solver.
struct Motion {
    bool implicit = false;                // backward Euler with lumped mass; else quasi-static
    Vector3 gravity = Vector3::Zero();    // [m/s²]
    double damping_time = 0.0;            // [s] τ: viscous stress τ C:ε̇ in each tetrahedron's own frame; zero: none
    bool share_pressure = false;          // the volume change is averaged over each of Mesh::patches
    double dt = 0.0;                      // [s] the scene's time step
};

/// Moves a mesh under weight, loads on nodes and forces on footprints, as Body says it: predict → (linearise → try_step)… →
/// commit or rollback. Contacts are numbered from 0; forces are those on the tissue.
class Solver {
public:
    Solver() = default;
    Solver(const Solver&) = delete;
    Solver& operator=(const Solver&) = delete;
    virtual ~Solver() = default;

    /// The loads at the end of every step from the next predict on; each call replaces the last, and rollback leaves it.
    virtual void load(std::span<const NodeForce> forces) = 0;

    /// Contact i acts on these nodes from now on.
    virtual void place(int contact, std::span<const NodeWeight> footprint) = 0;

    /// dt = 0: the last step again, from where it began, with whatever forces come.
    virtual void predict(double dt) = 0;

    /// About the latest trial state, for the first n contacts: fills `free` (3n, [m], mean displacement of each footprint as it
    /// would be without contact forces) and `compliance` (3n × 3n, [m/N], of the footprints' means, symmetric, not negative).
    virtual void linearise(int contacts, Eigen::Ref<VectorX> free, Eigen::Ref<MatrixX, 0, Eigen::OuterStride<>> compliance) = 0;

    /// These forces (3n, [N]) on the first n contacts give the new trial state. The residual is zero once the state is within the
    /// solver's accuracy.
    virtual StepReport try_step(Forces forces) = 0;

    virtual void commit() = 0;
    virtual void rollback() = 0;

    /// Of the latest trial state. `stored` counts weight's potential.
    [[nodiscard]] virtual EnergyReport energy() const = 0;

    [[nodiscard]] virtual Vector3 displacement(int node) const = 0;    // [m] of a mesh node, latest trial state

    /// Whether a tetrahedron of the latest trial state is turned inside out.
    [[nodiscard]] virtual bool inverted() const = 0;
};

}    // namespace stylet::corotational_fem
