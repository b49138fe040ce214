#include "contact/node_grid.h"

#include <numbers>

namespace stylet::corotational_fem {
namespace {

constexpr double most_cells = 8.0;    // for each node: a mesh as thin as a sheet still gets a small grid

/// Of six tetrahedra like this one made into a cube; of one that is longer than it is thick, as if it were as long all over.
double size_of(const Mesh& mesh, const Tetrahedron& tetrahedron) {
    double longest = 0.0;    // [m]
    for (int a = 0; a < 4; ++a) {
        for (int b = 0; b < a; ++b) longest = std::max(longest, (mesh.nodes[tetrahedron[a]] - mesh.nodes[tetrahedron[b]]).norm());
    }
    return std::max(std::cbrt(mesh.edges(tetrahedron).determinant()), longest * std::numbers::inv_sqrt3);
}

}    // namespace

NodeGrid::NodeGrid(const Mesh& mesh) : least_(mesh.nodes.front()), greatest_(mesh.nodes.front()) {
    for (const Vector3& node : mesh.nodes) {
        least_ = least_.cwiseMin(node);
        greatest_ = greatest_.cwiseMax(node);
    }
    const Vector3 extent = greatest_ - least_;
    const double nodes = static_cast<double>(mesh.nodes.size());
    edge_ = std::cbrt(extent.prod() / nodes);
    const auto cells = [&] { return (extent / edge_).array().ceil().max(1.0); };
    while (cells().prod() > most_cells * nodes) edge_ *= 2.0;
    for (int axis = 0; axis < 3; ++axis) counts_[axis] = static_cast<int>(cells()[axis]);
    list(mesh.nodes);
    measure(mesh);
}

void NodeGrid::list(const std::vector<Vector3>& nodes) {
    const auto index = [&](const Vector3& node) {
        const Cell cell = cell_of(node);
        return (cell[2] * counts_[1] + cell[1]) * counts_[0] + cell[0];
    };
    begins_.assign(static_cast<std::size_t>(counts_[0]) * counts_[1] * counts_[2] + 1, 0);
    for (const Vector3& node : nodes) ++begins_[index(node) + 1];
    for (std::size_t i = 1; i < begins_.size(); ++i) begins_[i] += begins_[i - 1];
    nodes_.resize(nodes.size());
    std::vector<int> next = begins_;
    for (std::size_t n = 0; n < nodes.size(); ++n) nodes_[next[index(nodes[n])]++] = static_cast<int>(n);
}

// Each tetrahedron marks the corners of all cells that its box meets. What no tetrahedron meets is as coarse as it gets.
void NodeGrid::measure(const Mesh& mesh) {
    sizes_.assign(static_cast<std::size_t>(counts_[0] + 1) * (counts_[1] + 1) * (counts_[2] + 1), 0.0);
    double largest = 0.0;    // [m]
    for (const Tetrahedron& tetrahedron : mesh.tetrahedra) {
        Vector3 least = mesh.nodes[tetrahedron[0]], greatest = least;
        for (const int node : tetrahedron) {
            least = least.cwiseMin(mesh.nodes[node]);
            greatest = greatest.cwiseMax(mesh.nodes[node]);
        }
        const double size = size_of(mesh, tetrahedron);
        largest = std::max(largest, size);
        const Cell first = cell_of(least), last = cell_of(greatest);
        for (int k = first[2]; k <= last[2] + 1; ++k) {
            for (int j = first[1]; j <= last[1] + 1; ++j) {
                for (int i = first[0]; i <= last[0] + 1; ++i) sizes_[corner(i, j, k)] = std::max(sizes_[corner(i, j, k)], size);
            }
        }
    }
    for (double& size : sizes_) size = size > 0.0 ? size : largest;
}

double NodeGrid::size_at(const Vector3& point) const {
    const Cell cell = cell_of(point);
    Vector3 t;    // from the cell's least corner, in edges
    for (int axis = 0; axis < 3; ++axis) t[axis] = std::clamp((point[axis] - least_[axis]) / edge_ - cell[axis], 0.0, 1.0);
    double size = 0.0;
    for (int c = 0; c < 8; ++c) {
        const int i = c & 1, j = c >> 1 & 1, k = c >> 2;
        const double share = (i ? t.x() : 1.0 - t.x()) * (j ? t.y() : 1.0 - t.y()) * (k ? t.z() : 1.0 - t.z());
        size += share * sizes_[corner(cell[0] + i, cell[1] + j, cell[2] + k)];
    }
    return size;
}

}    // namespace stylet::corotational_fem
