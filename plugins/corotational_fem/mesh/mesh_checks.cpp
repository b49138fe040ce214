#include "mesh/mesh_checks.h"

#include "mesh/complaints.h"
#include "mesh/faces.h"
#include "mesh/parts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace stylet::corotational_fem {
namespace {

constexpr double rounding = 1e-12;    // of the longest edge cubed: a volume as small as this may be one of coordinates' rounding

/// Outward, as long as twice the face's area [m²].
std::array<Vector3, 4> face_normals(const Mesh& mesh, const Tetrahedron& tetrahedron) {
    std::array<Vector3, 4> normals;
    for (int face = 0; face < 4; ++face) {
        const auto [a, b, c] = outward_face(tetrahedron, face);
        normals[face] = (mesh.nodes[b] - mesh.nodes[a]).cross(mesh.nodes[c] - mesh.nodes[a]);
    }
    return normals;
}

double volume_of(const Mesh& mesh, const Tetrahedron& nodes) {
    const Vector3& origin = mesh.nodes[nodes[0]];
    const auto edge = [&](int i) { return Vector3(mesh.nodes[nodes[i]] - origin); };
    return edge(1).cross(edge(2)).dot(edge(3)) / 6.0;
}

double longest_edge(const Mesh& mesh, const Tetrahedron& nodes) {
    double longest = 0.0;
    for (int i = 0; i < 4; ++i) {
        for (int j = 0; j < i; ++j) longest = std::max(longest, (mesh.nodes[nodes[i]] - mesh.nodes[nodes[j]]).norm());
    }
    return longest;
}

void check_shapes(const Mesh& mesh, Complaints& complaints) {
    int left_handed = 0;
    for (int t = 0; t < mesh.size(); ++t) {
        const Tetrahedron& nodes = mesh.tetrahedra[t];
        const double volume = volume_of(mesh, nodes), longest = longest_edge(mesh, nodes);
        const double zero = rounding * longest * longest * longest;
        const std::string of_volume = " has a volume of " + figure(volume) + " m^3";
        if (volume < -zero) {
            ++left_handed;
            complaints.add("inverted tetrahedra, wanted nodes in right-handed order", complaints.tetrahedron(t) + of_volume);
        } else if (volume <= zero) {
            complaints.add("flat tetrahedra, wanted some volume in each", complaints.tetrahedron(t) + of_volume);
        } else if (is_sliver(mesh, nodes)) {
            complaints.add("slivers, wanted no angle between faces below " + figure(least_dihedral_angle) +
                               " degrees and no longest edge over least height above " + figure(greatest_aspect),
                           complaints.tetrahedron(t) + " has " + figure(smallest_dihedral_angle(mesh, nodes)) + " degrees and " +
                               figure(aspect_of(mesh, nodes)));
        }
    }
    if (left_handed == mesh.size()) {
        complaints.add("a mesh that is left-handed throughout, wanted a right-handed one",
                       "its nodes' order, or one of its axes, is mirrored");
    }
}

void check_duplicates(const Mesh& mesh, Complaints& complaints) {
    std::vector<std::pair<Tetrahedron, int>> sorted;
    for (int t = 0; t < mesh.size(); ++t) {
        Tetrahedron nodes = mesh.tetrahedra[t];
        std::sort(nodes.begin(), nodes.end());
        sorted.emplace_back(nodes, t);
    }
    std::sort(sorted.begin(), sorted.end());
    for (std::size_t i = 1; i < sorted.size(); ++i) {
        if (sorted[i].first != sorted[i - 1].first) continue;
        complaints.add("duplicate tetrahedra, wanted each once", complaints.tetrahedron(sorted[i].second) + " is number " +
                                                                     complaints.name_of(sorted[i - 1].second) + " again");
    }
}

bool same_nodes(const Tetrahedron& a, const Tetrahedron& b) {
    return std::is_permutation(a.begin(), a.end(), b.begin());
}

/// Whether a right-handed tetrahedron lies on the side of its face from which the ascending nodes turn clockwise.
bool lies_behind(const Mesh& mesh, const FaceUse& use) {
    const Triangle nodes = outward_face(mesh.tetrahedra[use.tetrahedron], use.face);
    const auto least = std::min_element(nodes.begin(), nodes.end()) - nodes.begin();
    return nodes[(least + 1) % 3] < nodes[(least + 2) % 3];
}

/// Tetrahedra that share a face lie on either side of it, one on each.
void check_overlaps(const Mesh& mesh, std::span<const FaceUse> faces, Complaints& complaints) {
    for (std::size_t uses = 0; !faces.empty(); faces = faces.subspan(uses)) {
        uses = uses_of_first(faces);
        std::array<int, 2> first = {no_neighbour, no_neighbour};    // on each side
        for (const FaceUse& use : faces.first(uses)) {
            const int t = use.tetrahedron;
            if (volume_of(mesh, mesh.tetrahedra[t]) <= 0.0) continue;
            int& other = first[lies_behind(mesh, use) ? 1 : 0];
            if (other == no_neighbour) {
                other = t;
            } else if (!same_nodes(mesh.tetrahedra[t], mesh.tetrahedra[other])) {
                complaints.add("tetrahedra that overlap, wanted each on its own side of a common face",
                               complaints.tetrahedron(t) + " and number " + complaints.name_of(other));
            }
        }
    }
}

void check_nodes(const Mesh& mesh, Complaints& complaints) {
    if (std::find(mesh.fixed.begin(), mesh.fixed.end(), 0) == mesh.fixed.end()) {
        complaints.add("every node fixed, wanted some that are free", "nothing is left to move");
    }
    std::vector<char> used(mesh.nodes.size(), 0);
    for (const Tetrahedron& nodes : mesh.tetrahedra) {
        for (const int node : nodes) used[node] = 1;
    }
    for (int n = 0; n < mesh.node_count(); ++n) {
        if (used[n] != 0) continue;
        complaints.add("nodes of no tetrahedron, wanted none: without mass or stiffness they make the problem singular",
                       complaints.node(n));
    }
}

void check_parts(const Mesh& mesh, std::span<const FaceUse> faces, Complaints& complaints) {
    const Parts parts = parts_of(mesh, faces);
    const auto first_of = [](std::span<const int> of, int wanted) {
        return static_cast<int>(std::find(of.begin(), of.end(), wanted) - of.begin());
    };
    if (std::none_of(parts.is_held.begin(), parts.is_held.end(), [](char held) { return held != 0; })) {
        complaints.add("nothing fixed, wanted three nodes or more that are not on one line: without them the problem is singular",
                       "the whole mesh can move or turn freely");
        return;
    }
    for (int part = 0; part < static_cast<int>(parts.is_held.size()); ++part) {
        if (parts.is_held[part] != 0) continue;
        const auto size = std::count(parts.part.begin(), parts.part.end(), part);
        complaints.add(
            "parts that nothing holds, wanted three nodes or more, not on one line, that are fixed or in a part that is "
            "held: without them the problem is singular",
            std::to_string(size) + " tetrahedra around " + complaints.tetrahedron(first_of(parts.part, part)));
    }
    for (int body = 1; body < parts.body_count; ++body) {
        complaints.add("more than one body, wanted one (common nodes of neighbours not merged?)",
                       complaints.tetrahedron(first_of(parts.body, body)) + " shares no node with what was found before");
    }
}

}    // namespace

double smallest_dihedral_angle(const Mesh& mesh, const Tetrahedron& tetrahedron) {
    const std::array<Vector3, 4> normals = face_normals(mesh, tetrahedron);
    double smallest = std::numbers::pi;
    for (int i = 0; i < 4; ++i) {
        for (int j = 0; j < i; ++j) {
            // By the sine as well: the cosine of a small angle has lost it.
            smallest = std::min(smallest, std::atan2(normals[i].cross(normals[j]).norm(), -normals[i].dot(normals[j])));
        }
    }
    return smallest * 180.0 / std::numbers::pi;
}

double aspect_of(const Mesh& mesh, const Tetrahedron& tetrahedron) {
    double largest = 0.0;    // [m²] twice the area
    for (const Vector3& normal : face_normals(mesh, tetrahedron)) largest = std::max(largest, normal.norm());
    const double volume = std::abs(volume_of(mesh, tetrahedron));
    if (!(volume > 0.0)) return std::numeric_limits<double>::infinity();
    return longest_edge(mesh, tetrahedron) * largest / (6.0 * volume);
}

bool is_sliver(const Mesh& mesh, const Tetrahedron& tetrahedron) {
    return smallest_dihedral_angle(mesh, tetrahedron) < least_dihedral_angle || aspect_of(mesh, tetrahedron) > greatest_aspect;
}

void check_mesh(const Mesh& mesh, const MeshTags& tags, const std::string& key) {
    if (mesh.tetrahedra.empty()) throw Error(key, "found no tetrahedron, wanted at least one");
    Complaints complaints(mesh, tags);
    const std::vector<FaceUse> faces = sorted_faces(mesh);
    check_shapes(mesh, complaints);
    check_duplicates(mesh, complaints);
    check_overlaps(mesh, faces, complaints);
    check_nodes(mesh, complaints);
    check_parts(mesh, faces, complaints);
    complaints.throw_any(key);
}

}    // namespace stylet::corotational_fem
