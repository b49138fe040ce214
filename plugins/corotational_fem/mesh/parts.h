#pragma once

#include "mesh/faces.h"

namespace stylet::corotational_fem {

/// What of a mesh hangs together, and what of it is held.
struct Parts {
    std::vector<int> body;        // of each tetrahedron: what shares nodes is one body
    std::vector<int> part;        // of each tetrahedron: what shares faces is one part
    std::vector<char> is_held;    // of each part: three nodes, not on one line, are fixed or belong to a part that is held
    int body_count = 0;
};

/// Bodies and parts are numbered in order of their first tetrahedra.
[[nodiscard]] Parts parts_of(const Mesh& mesh, std::span<const FaceUse> sorted_faces);

}    // namespace stylet::corotational_fem
