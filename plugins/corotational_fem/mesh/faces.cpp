#include "mesh/faces.h"

#include <algorithm>
#include <tuple>

namespace stylet::corotational_fem {

std::vector<FaceUse> sorted_faces(const Mesh& mesh) {
    std::vector<FaceUse> faces;
    faces.reserve(4 * mesh.tetrahedra.size());
    for (int t = 0; t < mesh.size(); ++t) {
        for (int face = 0; face < 4; ++face) {
            Triangle nodes = outward_face(mesh.tetrahedra[t], face);
            std::sort(nodes.begin(), nodes.end());
            faces.push_back({nodes, t, face});
        }
    }
    std::sort(faces.begin(), faces.end(), [](const FaceUse& a, const FaceUse& b) {
        return std::tie(a.nodes, a.tetrahedron, a.face) < std::tie(b.nodes, b.tetrahedron, b.face);
    });
    return faces;
}

std::size_t uses_of_first(std::span<const FaceUse> faces) {
    std::size_t uses = 1;
    while (uses < faces.size() && faces[uses].nodes == faces[0].nodes) ++uses;
    return uses;
}

std::vector<std::array<int, 4>> neighbours_of(const Mesh& mesh) {
    std::vector<std::array<int, 4>> neighbours(mesh.tetrahedra.size());
    for (auto& across : neighbours) across.fill(no_neighbour);
    const std::vector<FaceUse> faces = sorted_faces(mesh);
    for (std::size_t i = 0; i + 1 < faces.size(); ++i) {
        const FaceUse &a = faces[i], &b = faces[i + 1];
        if (a.nodes != b.nodes) continue;
        neighbours[a.tetrahedron][a.face] = b.tetrahedron;
        neighbours[b.tetrahedron][b.face] = a.tetrahedron;
    }
    return neighbours;
}

std::vector<BoundaryFace> boundary_of(const Mesh& mesh, std::span<const std::array<int, 4>> neighbours) {
    std::vector<BoundaryFace> boundary;
    for (int t = 0; t < mesh.size(); ++t) {
        for (int face = 0; face < 4; ++face) {
            if (neighbours[t][face] == no_neighbour) boundary.push_back({outward_face(mesh.tetrahedra[t], face), t});
        }
    }
    return boundary;
}

}    // namespace stylet::corotational_fem
