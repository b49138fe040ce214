#pragma once

#include "mesh/buckets.h"
#include "mesh/faces.h"

namespace stylet::corotational_fem {

inline constexpr int no_tetrahedron = -1;

/// What of a mesh a material point lies in.
struct MeshPlace {
    int tetrahedron = no_tetrahedron;
    std::array<double, 4> weights{};    // barycentric: the point is Σ weights_i · node_i; they add up to one
};

/// Finds points in an undeformed mesh, and ways into it, from a grid of buckets: the cost doesn't grow with the mesh where its
/// tetrahedra are about as large as each other. Queries allocate nothing and may run at the same time.
///
/// Rounding: a point up to 1e-9 m outside of the boundary counts as inside (a weight may then be as little negative). A point on
/// a face shared by two layers belongs to the one below, the one whose tetrahedron has the lower centroid (of two as high as each
/// other, the layer that the scene names later). Where the face is horizontal this is exact to the last bit.
/// Validity: a mesh that check_mesh lets pass. The mesh must outlive the locator.
class Locator {
public:
    explicit Locator(const Mesh& mesh) : Locator(mesh, neighbours_of(mesh)) {}
    explicit Locator(const Mesh&&) = delete;

    [[nodiscard]] MeshPlace find(const Vector3& point) const;

    /// The fraction at which the way from `from` to `to` first crosses the boundary inwards, or −1 where it never does. A way
    /// that begins or ends on the boundary crosses it there, provided that it leads inwards.
    [[nodiscard]] double entry(const Vector3& from, const Vector3& to) const;

    [[nodiscard]] const std::vector<BoundaryFace>& boundary() const { return boundary_; }

private:
    Locator(const Mesh& mesh, std::span<const std::array<int, 4>> neighbours);

    /// The border of two layers as a tetrahedron has it.
    enum class Border : char { none, above, below };    // where the tetrahedron lies

    [[nodiscard]] Border border_of(int tetrahedron, int neighbour) const;
    [[nodiscard]] Buckets tetrahedra_by_place() const;
    [[nodiscard]] Buckets faces_by_place() const;

    const Mesh* mesh_;
    std::vector<BoundaryFace> boundary_;
    std::vector<std::array<Border, 4>> borders_;    // of each tetrahedron's faces
    Buckets tetrahedra_;
    Buckets faces_;    // of the boundary
};

}    // namespace stylet::corotational_fem
