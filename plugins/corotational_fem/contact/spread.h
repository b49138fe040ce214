// How a contact, far smaller than a tetrahedron, acts on the nodes of a mesh.
#pragma once

#include "contact/node_grid.h"
#include "solver.h"

#include <stylet/body.h>

#include <array>
#include <span>
#include <vector>

namespace stylet::corotational_fem {

/// The balls whose nodes carry a contact, each an even share of its force.
struct Balls {
    static constexpr int most = 8;

    std::array<Vector3, most> centres;    // [m]
    double radius = 0.0;                  // [m] of each
    int count = 0;
};

/// Spreads a contact over the nodes within ρ of it, smoothly, so that a mesh answers alike wherever in a tetrahedron it is:
///
///     w_n ∝ V_n [φ(|x_n − x|/ρ) + φ(|x_n − x*|/ρ)],   φ(q) = (1 − q²)² for q < 1,   Σ w_n = 1
///
/// V_n is the node's share of volume, and x* the mirror image of x above the undeformed surface z = 0: what of a ball would be
/// outside there is folded back. ρ is twice the edge of a cube of six tetrahedra, or 1.6 radii of a needle that is thick beside
/// that. A piece of shaft is an even row of balls, at Gauss points two by two.
///
/// In a mesh of cubes of edge h the mesh's own self-compliance is then the same within 4 % at nodes, on edges, on faces and in
/// the middle of tetrahedra (of ρ = 1.5 h it would be 8 %).
class Spread {
public:
    /// `mesh` must outlive it. `needle_radius` [m], zero where there is no needle.
    Spread(const Mesh& mesh, double needle_radius);

    /// The nodes on which a contact acts, each once; holds until the next call. A contact outside of the mesh's box counts as on
    /// it; one that isn't finite, or in a void larger than the tetrahedra about it, acts on none.
    [[nodiscard]] std::span<const NodeWeight> of(const ContactPoint& point);

    /// None for a contact that isn't finite.
    [[nodiscard]] Balls balls(const ContactPoint& point) const;

    [[nodiscard]] double needle_radius() const { return needle_radius_; }    // [m]

private:
    const Mesh& mesh_;
    double needle_radius_;    // [m]
    NodeGrid grid_;
    std::vector<double> volumes_;    // [m³] of each node
    std::vector<NodeWeight> weights_;
};

}    // namespace stylet::corotational_fem
