#include "mesh/locator.h"

#include <algorithm>
#include <cmath>

namespace stylet::corotational_fem {
namespace {

constexpr double tolerance = 1e-9;    // [m] far below what a hand could place, far above the rounding of any block's coordinates

/// A plane through three nodes. `normal` has the length of twice their triangle's area [m²].
struct Plane {
    Vector3 normal;
    Vector3 origin;

    Plane(const Mesh& mesh, const Triangle& nodes)
        : normal((mesh.nodes[nodes[1]] - mesh.nodes[nodes[0]]).cross(mesh.nodes[nodes[2]] - mesh.nodes[nodes[0]])),
          origin(mesh.nodes[nodes[0]]) {}

    /// Height over the plane times the normal's length [m³]. Of a horizontal plane its sign is exact.
    [[nodiscard]] double side(const Vector3& point) const { return normal.dot(point - origin); }
};

bool near_or_positive(double side, const Plane& plane) {
    return side >= 0.0 || side * side <= tolerance * tolerance * plane.normal.squaredNorm();
}

/// Whether all of a box lies farther out of the plane than the tolerance.
bool beyond(const Plane& plane, const Box& box) {
    const Vector3 nearest = (plane.normal.array() > 0.0).select(box.least, box.greatest);
    const double side = plane.side(nearest);
    return side > 0.0 && !near_or_positive(-side, plane);
}

/// Whether a point of the triangle's plane lies in the triangle.
bool covers(const Mesh& mesh, const Triangle& nodes, const Vector3& normal, const Vector3& point) {
    for (int i = 0; i < 3; ++i) {
        const Vector3& begin = mesh.nodes[nodes[i]];
        const Vector3 edge = mesh.nodes[nodes[(i + 1) % 3]] - begin;
        const Vector3 inwards = normal.cross(edge);
        const double side = inwards.dot(point - begin);
        if (side < 0.0 && side * side > tolerance * tolerance * inwards.squaredNorm()) return false;
    }
    return true;
}

double centroid_height(const Mesh& mesh, int tetrahedron) {
    double sum = 0.0;
    for (const int node : mesh.tetrahedra[tetrahedron]) sum += mesh.nodes[node].z();
    return 0.25 * sum;
}

}    // namespace

Locator::Locator(const Mesh& mesh, std::span<const std::array<int, 4>> neighbours)
    : mesh_(&mesh), boundary_(boundary_of(mesh, neighbours)), tetrahedra_(tetrahedra_by_place()), faces_(faces_by_place()) {
    for (int t = 0; t < mesh.size(); ++t) {
        auto& borders = borders_.emplace_back();
        for (int face = 0; face < 4; ++face) borders[face] = border_of(t, neighbours[t][face]);
    }
}

Locator::Border Locator::border_of(int tetrahedron, int neighbour) const {
    if (neighbour == no_neighbour) return Border::none;
    const int layer = mesh_->layers[tetrahedron], other = mesh_->layers[neighbour];
    if (layer == other) return Border::none;
    const double higher = centroid_height(*mesh_, tetrahedron) - centroid_height(*mesh_, neighbour);
    const bool above = std::abs(higher) > tolerance ? higher > 0.0 : layer < other;
    return above ? Border::above : Border::below;
}

Buckets Locator::tetrahedra_by_place() const {
    std::vector<Box> boxes;
    std::vector<Plane> planes;    // four each
    for (const Tetrahedron& nodes : mesh_->tetrahedra) {
        Box& box = boxes.emplace_back();
        for (const int node : nodes) box.take_in(mesh_->nodes[node]);
        for (int face = 0; face < 4; ++face) planes.emplace_back(*mesh_, outward_face(nodes, face));
    }
    return {boxes, tolerance, [&planes](int tetrahedron, const Box& box) {
                const auto first = planes.begin() + 4 * tetrahedron;
                return std::none_of(first, first + 4, [&box](const Plane& plane) { return beyond(plane, box); });
            }};
}

Buckets Locator::faces_by_place() const {
    std::vector<Box> boxes;
    for (const BoundaryFace& face : boundary_) {
        Box& box = boxes.emplace_back();
        for (const int node : face.nodes) box.take_in(mesh_->nodes[node]);
    }
    return {boxes, tolerance, [this](int face, const Box& box) {
                const auto [a, b, c] = boundary_[face].nodes;
                return !beyond(Plane(*mesh_, {a, b, c}), box) && !beyond(Plane(*mesh_, {a, c, b}), box);
            }};
}

MeshPlace Locator::find(const Vector3& point) const {
    MeshPlace best;
    int best_rank = -1;
    double best_least = 0.0;
    for (const int t : tetrahedra_.at(point)) {
        // On a border of layers it is the tetrahedra with a face there that know its sides; one with but an edge there doesn't.
        enum Rank { wrong_side, away_from_borders, right_side };
        int rank = away_from_borders;
        MeshPlace place{.tetrahedron = t};
        double volume = 0.0;    // six times [m³]
        bool inside = true;
        for (int face = 0; face < 4 && inside; ++face) {
            const Plane plane(*mesh_, outward_face(mesh_->tetrahedra[t], face));
            const double side = -plane.side(point);
            inside = near_or_positive(side, plane);
            place.weights[face] = side;
            volume += side;
            const Border border = borders_[t][face];
            if (border != Border::none && near_or_positive(-std::abs(side), plane) && rank != wrong_side) {
                rank = side > 0.0 || (side == 0.0 && border == Border::below) ? right_side : wrong_side;
            }
        }
        if (!inside || rank < best_rank) continue;
        for (double& weight : place.weights) weight /= volume;
        const double least = *std::min_element(place.weights.begin(), place.weights.end());
        if (rank == best_rank && least <= best_least) continue;
        best = place;
        best_rank = rank;
        best_least = least;
    }
    return best;
}

double Locator::entry(const Vector3& from, const Vector3& to) const {
    constexpr double none = -1.0;
    double first = none;
    faces_.along(from, to, [&](std::span<const int> faces, double upto) {
        for (const int face : faces) {
            const Triangle& nodes = boundary_[face].nodes;
            const Plane plane(*mesh_, nodes);
            const double before = plane.side(from), after = plane.side(to);
            if (before < 0.0 || after > 0.0 || !(before > after)) continue;
            const double fraction = before / (before - after);
            if (first >= 0.0 && fraction >= first) continue;
            if (covers(*mesh_, nodes, plane.normal, from + fraction * (to - from))) first = fraction;
        }
        return first < 0.0 || first > upto;
    });
    return first;
}

}    // namespace stylet::corotational_fem
