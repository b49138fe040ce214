// The discrete rod: nodes, edges between them, joints where edges meet. It lives in the frame of its base and knows neither
// contacts nor time.
#pragma once

#include "band_ldlt.h"
#include "joint.h"

#include <vector>

namespace stylet::rod {

using Vector2 = Eigen::Vector2d;

/// What the rod is made of, all along it.
struct Section {
    double stretching;    // [N] EA
    Vector2 bending;      // [N·m²] EI about the second and about the first director: they are equal for any needle
    double twisting;      // [N·m²] GJ
};

struct ChainSetup {
    int edges;
    double length;    // [m]
    Section section;
    bool clamped;    // the base holds the first edge's direction and twist; else it is pinned, and holds its spin alone
    std::vector<double> natural_curvature;    // [1/m] toward the first director, of each of the `edges` joints
};

/// A shape of the chain. Node i is at i·edge_length along −z plus its displacement, so that a nearly straight needle's strains
/// don't drown in rounding.
struct Shape {
    std::vector<Vector3> displacement;      // [m] of the nodes; the first is the base and stays zero
    std::vector<double> angle;              // [rad] of each edge's material about its reference director
    std::vector<Vector3> reference;         // unit, across each edge
    std::vector<double> reference_twist;    // [rad] at each joint, between the references of its two edges
};

/// How fast bending and twisting are resisted: a moment B·rate·(κ − before)/ℓ on top of the elastic one (Kelvin and Voigt).
struct Viscosity {
    double rate;                          // [1] retardation time over the time step
    const std::vector<Strain>* before;    // of each joint, at the start of the step
};

/// A chain of straight edges with the energy
///
///     U = Σ edges EA (|e| − ℓ)²/2ℓ + Σ joints [(κ − κ̄)ᵀ B (κ − κ̄) + GJ m²]/2ℓj
///
/// where ℓj is the edge's length ℓ, and ℓ/2 for joint 0, at which the first edge bends against the clamp. A discrete elastic rod:
/// geometrically exact, second order in ℓ. Source: Bergou et al. 2008, 2010. Deviation: the material's angles are unknowns beside
/// the nodes and have no inertia; the clamp is a joint of half a length instead of a fixed edge.
/// The unknowns x are, edge by edge, its far node's displacement (3) and its angle (1): 4·edges, in a band of 11.
class Chain {
public:
    explicit Chain(const ChainSetup& setup);

    [[nodiscard]] int edges() const { return setup_.edges; }
    [[nodiscard]] int nodes() const { return setup_.edges + 1; }
    [[nodiscard]] int unknowns() const { return 4 * setup_.edges; }
    [[nodiscard]] double edge_length() const { return edge_length_; }    // [m]
    [[nodiscard]] const ChainSetup& setup() const { return setup_; }
    [[nodiscard]] static int unknown_of(int node) { return 4 * (node - 1); }    // of a node but the base
    static const Vector3 axis;                                                  // along the straight chain, from the base

    [[nodiscard]] Shape straight() const;

    /// x ← x + dx, the references transported in parallel.
    void move(const VectorX& dx, Shape& shape) const;

    [[nodiscard]] double energy(const Shape& shape) const;    // [J]

    /// [N] tension of edge i.
    [[nodiscard]] double tension(const Shape& shape, int edge) const;
    /// [N] what it changes by when x moves by dx, to first order.
    [[nodiscard]] double tension_change(const Shape& shape, const VectorX& dx, int edge) const;

    [[nodiscard]] Strain strain(const Shape& shape, int joint) const;
    [[nodiscard]] double joint_length(int joint) const { return joint == 0 ? 0.5 * edge_length_ : edge_length_; }    // [m]
    /// [N·m] per curvature κ1, κ2 and per twist m of a joint; a hinge resists no bending.
    [[nodiscard]] Vector3 bending_and_twisting(int joint) const;

    /// ∇U, with the viscosity's moments. [N] and [N·m].
    void gradient(const Shape& shape, const Viscosity& viscosity, VectorX& gradient) const;

    /// ∇U and ∇²U, where the edges' own tensions [N] are replaced by `tensions` in their geometric stiffness: those that the last
    /// linear solve found, so that Newton needs fewer steps (the mixed form). Adds to the matrix, sets the gradient.
    void linearise(const Shape& shape, const std::vector<double>& tensions, const Viscosity& viscosity, BandLdlt& tangent,
                   VectorX& gradient) const;

private:
    [[nodiscard]] Edge edge(const Shape& shape, int i) const;
    [[nodiscard]] bool hinged(int joint) const { return joint == 0 && !setup_.clamped; }
    [[nodiscard]] Strain beyond_rest(int joint, const Strain& strain) const;
    [[nodiscard]] Edge edge_before(const Shape& shape, int joint, const Edge& after) const;
    [[nodiscard]] double twist(const Shape& shape, int joint) const;    // [rad]
    template <class Visit>
    void each_joint(const Shape& shape, Visit visit) const;
    [[nodiscard]] Vector3 moments(int joint, const Strain& strain, const Viscosity& viscosity) const;
    [[nodiscard]] double strained_by(const Shape& shape, int edge) const;
    void add_stretching(const Shape& shape, VectorX& gradient) const;
    void add_joint(int joint, const JointVector& g, VectorX& gradient) const;
    void add_joint(int joint, const JointMatrix& h, BandLdlt& tangent) const;

    ChainSetup setup_;
    double edge_length_;    // [m]
};

}    // namespace stylet::rod
