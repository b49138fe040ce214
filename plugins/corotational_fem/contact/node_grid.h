#pragma once

#include "mesh/mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace stylet::corotational_fem {

/// The nodes of a mesh by place, and how large its tetrahedra are anywhere. Queries allocate nothing.
class NodeGrid {
public:
    explicit NodeGrid(const Mesh& mesh);

    /// The nearest point of the mesh's box.
    [[nodiscard]] Vector3 inside(const Vector3& point) const { return point.cwiseMax(least_).cwiseMin(greatest_); }

    /// Edge of the cube that six tetrahedra as large as those near `point` would fill [m]: of none that meets the point's cell is
    /// it less. Continuous. `point` is finite.
    [[nodiscard]] double size_at(const Vector3& point) const;

    /// Calls visit(node) for every node of a box, and for some nodes beside it, in one order always.
    template <typename Visit>
    void for_each_in(const Vector3& least, const Vector3& greatest, Visit visit) const {
        const Cell first = cell_of(least), last = cell_of(greatest);
        for (int k = first[2]; k <= last[2]; ++k) {
            for (int j = first[1]; j <= last[1]; ++j) {
                const int row = (k * counts_[1] + j) * counts_[0];
                for (int n = begins_[row + first[0]]; n < begins_[row + last[0] + 1]; ++n) visit(nodes_[n]);
            }
        }
    }

private:
    using Cell = std::array<int, 3>;

    [[nodiscard]] Cell cell_of(const Vector3& point) const {    // the nearest
        Cell cell{};
        for (int axis = 0; axis < 3; ++axis) {
            const double place = std::floor((point[axis] - least_[axis]) / edge_);
            cell[axis] = static_cast<int>(std::clamp(place, 0.0, counts_[axis] - 1.0));
        }
        return cell;
    }
    [[nodiscard]] int corner(int i, int j, int k) const { return (k * (counts_[1] + 1) + j) * (counts_[0] + 1) + i; }

    void list(const std::vector<Vector3>& nodes);
    void measure(const Mesh& mesh);

    Vector3 least_, greatest_;    // [m] of the mesh
    double edge_;                 // [m] of a cell
    Cell counts_{};
    std::vector<int> begins_;    // of each cell, into nodes_; one more than there are cells
    std::vector<int> nodes_;
    std::vector<double> sizes_;    // [m] at the cells' corners
};

}    // namespace stylet::corotational_fem
