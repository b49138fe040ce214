#include "mesh/buckets.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace stylet::corotational_fem {
namespace {

constexpr double most_along_an_axis = 1024.0;    // a bar as thin as a hair still gets a small grid

}    // namespace

Buckets::Buckets(std::span<const Box> items, double margin, const Reaches& reaches) {
    for (const Box& box : items) {
        bounds_.take_in(box.least);
        bounds_.take_in(box.greatest);
    }
    bounds_ = bounds_.grown(margin);
    const Vector3 size = bounds_.size();
    const double edge = std::cbrt(size.prod() / static_cast<double>(items.size()));
    for (int axis = 0; axis < 3; ++axis) {
        counts_[axis] = static_cast<int>(std::clamp(std::round(size[axis] / edge), 1.0, most_along_an_axis));
        cell_size_[axis] = size[axis] / counts_[axis];
    }

    std::vector<std::pair<std::size_t, int>> listed;    // bucket, item
    for (int item = 0; item < static_cast<int>(items.size()); ++item) {
        const Box box = items[item].grown(margin);
        const Cell first = cell_of(box.least), last = cell_of(box.greatest);
        Cell cell = first;
        for (cell[2] = first[2]; cell[2] <= last[2]; ++cell[2]) {
            for (cell[1] = first[1]; cell[1] <= last[1]; ++cell[1]) {
                for (cell[0] = first[0]; cell[0] <= last[0]; ++cell[0]) {
                    const Vector3 corner = bounds_.least + Vector3(cell[0], cell[1], cell[2]).cwiseProduct(cell_size_);
                    if (reaches(item, Box{corner, corner + cell_size_}.grown(margin))) listed.emplace_back(index(cell), item);
                }
            }
        }
    }
    begins_.assign(static_cast<std::size_t>(counts_[0]) * counts_[1] * counts_[2] + 1, 0);
    for (const auto& [bucket, item] : listed) ++begins_[bucket + 1];
    std::partial_sum(begins_.begin(), begins_.end(), begins_.begin());
    std::vector<std::size_t> next = begins_;
    items_.resize(listed.size());
    for (const auto& [bucket, item] : listed) items_[next[bucket]++] = item;
}

Buckets::Cell Buckets::cell_of(const Vector3& point) const {
    Cell cell{};
    for (int axis = 0; axis < 3; ++axis) {
        const double place = std::floor((point[axis] - bounds_.least[axis]) / cell_size_[axis]);
        cell[axis] = static_cast<int>(std::clamp(place, 0.0, counts_[axis] - 1.0));
    }
    return cell;
}

std::span<const int> Buckets::at(const Vector3& point) const {
    if (!bounds_.holds(point)) return {};
    return items_of(cell_of(point));
}

}    // namespace stylet::corotational_fem
