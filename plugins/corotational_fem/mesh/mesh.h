// A tetrahedral mesh of the undeformed tissue.
#pragma once

#include <stylet/types.h>

#include <array>
#include <cstdint>
#include <vector>

namespace stylet::corotational_fem {

using Tetrahedron = std::array<int, 4>;    // nodes; right-handed: (x1 − x0) × (x2 − x0) · (x3 − x0) > 0

struct Mesh {
    std::vector<Vector3> nodes;    // [m] undeformed, world
    std::vector<Tetrahedron> tetrahedra;
    std::vector<int> layers;     // of each tetrahedron, an index into the tissue's layers
    std::vector<char> fixed;     // of each node, whether it is held
    std::vector<int> patches;    // of each tetrahedron, the group of neighbours with which it may share one pressure

    [[nodiscard]] int node_count() const { return static_cast<int>(nodes.size()); }
    [[nodiscard]] int size() const { return static_cast<int>(tetrahedra.size()); }

    /// From its first node to each of the others [m], a column each.
    [[nodiscard]] Matrix3 edges(const Tetrahedron& tetrahedron) const {
        Matrix3 edges;
        for (int i = 0; i < 3; ++i) edges.col(i) = nodes[tetrahedron[i + 1]] - nodes[tetrahedron[0]];
        return edges;
    }
    [[nodiscard]] double volume(const Tetrahedron& tetrahedron) const {
        return edges(tetrahedron).determinant() / 6.0;
    }    // [m³]
};

/// What the source of a mesh calls its nodes and tetrahedra. Empty: by their index.
struct MeshTags {
    std::vector<std::uint64_t> nodes;
    std::vector<std::uint64_t> tetrahedra;
};

/// Isotropic linear elasticity of a layer.
struct Material {
    double shear_modulus;    // [Pa] μ = E/(2(1 + ν))
    double lame;             // [Pa] λ = Eν/((1 + ν)(1 − 2ν))
    double density;          // [kg/m³], NaN where the scene gives none
};

}    // namespace stylet::corotational_fem
