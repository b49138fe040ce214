#pragma once

#include <stylet/types.h>

#include <algorithm>
#include <array>
#include <functional>
#include <limits>
#include <span>
#include <vector>

namespace stylet::corotational_fem {

struct Box {
    Vector3 least = Vector3::Constant(std::numeric_limits<double>::infinity());        // [m]
    Vector3 greatest = Vector3::Constant(-std::numeric_limits<double>::infinity());    // [m]

    void take_in(const Vector3& point) {
        least = least.cwiseMin(point);
        greatest = greatest.cwiseMax(point);
    }
    [[nodiscard]] Box grown(double margin) const {
        return {least - Vector3::Constant(margin), greatest + Vector3::Constant(margin)};
    }
    [[nodiscard]] Vector3 size() const { return greatest - least; }
    [[nodiscard]] bool holds(const Vector3& point) const {    // never a NaN
        return (point.array() >= least.array()).all() && (point.array() <= greatest.array()).all();
    }
};

/// A uniform grid of boxes, about as many as there are items, each of which lists the items that reach into it. An item is listed
/// a `margin` further than it reaches, so that rounding loses none.
class Buckets {
public:
    /// May `item` reach into the box? Asked for the boxes that the item's own box meets; true is always right, false saves time.
    using Reaches = std::function<bool(int item, const Box& box)>;

    Buckets(std::span<const Box> items, double margin, const Reaches& reaches);

    /// The items near a point; none where it lies outside of the grid. A NaN lies outside.
    [[nodiscard]] std::span<const int> at(const Vector3& point) const;

    /// Calls visit(items, upto) for the buckets on the way from `from` to `to`, in order, until it returns false: the way leaves
    /// the bucket at the fraction `upto`. A way that is not finite meets none.
    template <typename Visit>
    void along(const Vector3& from, const Vector3& to, Visit visit) const;

private:
    using Cell = std::array<int, 3>;

    [[nodiscard]] Cell cell_of(const Vector3& point) const;    // the nearest
    [[nodiscard]] std::size_t index(const Cell& cell) const {
        return (static_cast<std::size_t>(cell[2]) * counts_[1] + cell[1]) * counts_[0] + cell[0];
    }
    [[nodiscard]] std::span<const int> items_of(const Cell& cell) const {
        const std::size_t begin = begins_[index(cell)], end = begins_[index(cell) + 1];
        return {items_.data() + begin, end - begin};
    }

    Box bounds_;
    Vector3 cell_size_;    // [m]
    Cell counts_{};
    std::vector<std::size_t> begins_;    // of each bucket, into items_; one more than there are buckets
    std::vector<int> items_;
};

// After Amanatides and Woo 1987.
template <typename Visit>
void Buckets::along(const Vector3& from, const Vector3& to, Visit visit) const {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const Vector3 way = to - from;
    if (!from.allFinite() || !way.allFinite()) return;
    double begin = 0.0, end = 1.0;    // what of the way is inside the grid
    for (int axis = 0; axis < 3; ++axis) {
        if (way[axis] == 0.0) {
            if (from[axis] < bounds_.least[axis] || from[axis] > bounds_.greatest[axis]) return;
            continue;
        }
        const double a = (bounds_.least[axis] - from[axis]) / way[axis], b = (bounds_.greatest[axis] - from[axis]) / way[axis];
        begin = std::max(begin, std::min(a, b));
        end = std::min(end, std::max(a, b));
    }
    if (!(begin <= end)) return;

    Cell cell = cell_of(from + begin * way);
    const auto leaves = [&](int axis) {    // fraction at which the way leaves the cell across this axis
        if (way[axis] == 0.0) return infinity;
        const double border = bounds_.least[axis] + (cell[axis] + (way[axis] > 0.0 ? 1 : 0)) * cell_size_[axis];
        return (border - from[axis]) / way[axis];
    };
    Vector3 next(leaves(0), leaves(1), leaves(2));
    while (true) {
        int axis = 0;
        const double upto = next.minCoeff(&axis);
        if (!visit(items_of(cell), upto) || upto >= end) return;
        cell[axis] += way[axis] > 0.0 ? 1 : -1;
        if (cell[axis] < 0 || cell[axis] >= counts_[axis]) return;
        next[axis] = leaves(axis);
    }
}

}    // namespace stylet::corotational_fem
