#include "load/patch_weights.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace stylet::corotational_fem {

namespace {

// Nodes are where cells and files put them, in decimals that were rounded: so near to a side of the box they lie on it.
constexpr double rounding = 1e-9;    // [m]

// Of a face's area: what rounding leaves of one that meets the box in an edge or a corner alone.
constexpr double sliver = 1e-12;

/// A corner of what is left of a face: the hat functions of the face's nodes there, which are its barycentric coordinates.
struct Corner {
    Vector3 hats;
    Vector3 place;    // [m]
};

using Polygon = std::vector<Corner>;

Polygon corners_of(const BoundaryFace& face, const Mesh& mesh) {
    Polygon corners;
    for (int i = 0; i < 3; ++i) corners.push_back({Vector3::Unit(i), mesh.nodes[face.nodes[i]]});
    return corners;
}

// Keeps what lies where side · (x − limit) ≤ 0 along an axis; side is 1 or −1.
Polygon cut(const Polygon& polygon, int axis, double side, double limit) {
    Polygon kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Corner &from = polygon[i], &to = polygon[(i + 1) % polygon.size()];
        const double before = side * (from.place[axis] - limit), after = side * (to.place[axis] - limit);    // [m] beyond it
        if (before <= 0.0) kept.push_back(from);
        if ((before < 0.0 && after > 0.0) || (before > 0.0 && after < 0.0)) {
            const double share = before / (before - after);
            kept.push_back({from.hats + share * (to.hats - from.hats), from.place + share * (to.place - from.place)});
        }
    }
    return kept;
}

Polygon cut_to_box(Polygon polygon, const Patch& patch) {
    for (int axis = 0; axis < 3; ++axis) {
        const double centre = patch.centre[axis], half = 0.5 * patch.size[axis];
        const bool within = std::all_of(polygon.begin(), polygon.end(), [&](const Corner& corner) {
            return std::abs(corner.place[axis] - centre) <= half + rounding;
        });
        if (!within) polygon = cut(cut(polygon, axis, 1.0, centre + half), axis, -1.0, centre - half);
    }
    return polygon;
}

double area_of(const BoundaryFace& face, const Mesh& mesh) {
    const Vector3& origin = mesh.nodes[face.nodes[0]];
    return 0.5 * (mesh.nodes[face.nodes[1]] - origin).cross(mesh.nodes[face.nodes[2]] - origin).norm();    // [m²]
}

// Of each of its nodes' hat functions over what is left of a face, per area of the face. Their sum is the share that is left.
Vector3 integrals(const Polygon& polygon) {
    Vector3 sum = Vector3::Zero();
    for (std::size_t i = 2; i < polygon.size(); ++i) {
        const Vector3 &a = polygon[0].hats, &b = polygon[i - 1].hats, &c = polygon[i].hats;
        sum += std::abs(a.dot(b.cross(c))) / 3.0 * (a + b + c);    // the triangle's share times its mean
    }
    return sum;
}

bool holds(const Patch& patch, const Vector3& point) {
    return ((point - patch.centre).array().abs() <= 0.5 * patch.size.array() + rounding).all();
}

}    // namespace

std::vector<NodeWeight> weights_by_nodes(const Patch& patch, const Mesh& mesh, std::span<const BoundaryFace> boundary) {
    std::set<int> nodes;
    for (const BoundaryFace& face : boundary) {
        for (const int node : face.nodes) {
            if (holds(patch, mesh.nodes[node])) nodes.insert(node);
        }
    }
    std::vector<NodeWeight> weights;
    for (const int node : nodes) weights.push_back({node, 1.0 / static_cast<double>(nodes.size())});
    return weights;
}

std::vector<NodeWeight> weights_by_area(const Patch& patch, const Mesh& mesh, std::span<const BoundaryFace> boundary) {
    std::map<int, double> areas;    // [m²] of the nodes
    double area = 0.0;              // [m²]
    for (const BoundaryFace& face : boundary) {
        const Vector3 left = integrals(cut_to_box(corners_of(face, mesh), patch));
        if (left.sum() <= sliver) continue;
        const double whole = area_of(face, mesh);
        for (int i = 0; i < 3; ++i) areas[face.nodes[i]] += whole * left[i];
        area += whole * left.sum();
    }
    std::vector<NodeWeight> weights;
    for (const auto& [node, share] : areas) weights.push_back({node, share / area});
    return weights;
}

}    // namespace stylet::corotational_fem
