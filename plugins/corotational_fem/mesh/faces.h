// The faces of a mesh: which tetrahedra meet there, and where the mesh ends.
#pragma once

#include "mesh/mesh.h"

#include <span>

namespace stylet::corotational_fem {

using Triangle = std::array<int, 3>;    // nodes

/// Face i of a tetrahedron lies opposite its node i; counter-clockwise as seen from outside.
inline constexpr std::array<Triangle, 4> faces_of_tetrahedron = {{{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};

[[nodiscard]] inline Triangle outward_face(const Tetrahedron& tetrahedron, int face) {
    const Triangle& corners = faces_of_tetrahedron[face];
    return {tetrahedron[corners[0]], tetrahedron[corners[1]], tetrahedron[corners[2]]};
}

/// A face as one tetrahedron has it.
struct FaceUse {
    Triangle nodes;    // ascending
    int tetrahedron;
    int face;    // of the tetrahedron
};

/// Every face of every tetrahedron. Uses of the same face are neighbours: in a sound mesh two inside, one on the boundary.
[[nodiscard]] std::vector<FaceUse> sorted_faces(const Mesh& mesh);

/// How many uses, from the first of `faces`, are of the same face.
[[nodiscard]] std::size_t uses_of_first(std::span<const FaceUse> faces);

inline constexpr int no_neighbour = -1;

/// Of each tetrahedron, the one across each of its faces, or `no_neighbour`. Validity: no face has more than two uses.
[[nodiscard]] std::vector<std::array<int, 4>> neighbours_of(const Mesh& mesh);

struct BoundaryFace {
    Triangle nodes;    // counter-clockwise as seen from outside
    int tetrahedron;
};

/// In order of their tetrahedra.
[[nodiscard]] std::vector<BoundaryFace> boundary_of(const Mesh& mesh, std::span<const std::array<int, 4>> neighbours);

}    // namespace stylet::corotational_fem
