// The matrix of one implicit step of the undeformed mesh.
#pragma once

#include "mesh/mesh.h"
#include "solver.h"

#include <span>
#include <vector>

namespace stylet::corotational_fem {

/// A symmetric matrix of 3 × 3 blocks, one row of blocks for each node that is free to move; both triangles are stored.
struct BlockMatrix {
    std::vector<int> start;        // of each row among `column` and `block`; one more than there are rows
    std::vector<int> column;       // ascending within a row, the diagonal among them
    std::vector<Matrix3> block;    // [N/m]
    std::vector<int> mesh_node;    // of each row
    std::vector<int> row;          // of each mesh node; −1: fixed

    [[nodiscard]] int rows() const { return static_cast<int>(mesh_node.size()); }
};

/// A = M/dt² + (1 + τ/dt) K for backward Euler, A = K for the quasi-static case. K is the linear stiffness of the tetrahedra,
///     K_ab = V [λ ∇φa ∇φbᵀ + μ (∇φb ∇φaᵀ + ∇φa·∇φb I)],
/// with the volume's part averaged over each patch where Motion::share_pressure says so, and M lumped: a quarter of each
/// tetrahedron's mass at each of its nodes. `materials` are indexed by Mesh::layers.
[[nodiscard]] BlockMatrix rest_matrix(const Mesh& mesh, std::span<const Material> materials, const Motion& motion);

}    // namespace stylet::corotational_fem
