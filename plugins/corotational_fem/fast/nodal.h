// Nodal vectors in single precision, and sums over them.
#pragma once

#include "fast/lanes.h"
#include "fast/shares.h"

#include <stylet/workers.h>

#include <algorithm>
#include <array>
#include <vector>

namespace stylet::corotational_fem {

using NodalVector = std::vector<Float4>;    // of each place, in the order of the factor

using Quad = float __attribute__((vector_size(16)));
using DoubleQuad = double __attribute__((vector_size(32), aligned(16)));

inline Quad& quad(Float4& v) {
    return reinterpret_cast<Quad&>(v);
}
inline const Quad& quad(const Float4& v) {
    return reinterpret_cast<const Quad&>(v);
}

/// Loops over the nodes of one vector, cut the same way for any number of threads. A loop over few nodes is done by the caller
/// alone: to share it would take longer.
class NodeLoops {
public:
    NodeLoops(int nodes, Workers& workers) : nodes_(nodes), workers_(nodes < worth_sharing ? one_thread() : workers) {}

    [[nodiscard]] int nodes() const { return nodes_; }

    template <class Each>
    void each(Each&& each) const {
        workers_.each(tasks, [&](int task) {
            for (int i = share_start(nodes_, task); i < share_start(nodes_, task + 1); ++i) each(i);
        });
    }

    /// `count` sums over the nodes at once: each(i, sums) adds node i's part to each of them. Single precision over runs of a few
    /// nodes, double from there on, always in the same order.
    template <int count, class Each>
    [[nodiscard]] std::array<double, count> sums(Each&& each) const {
        std::array<std::array<double, count>, tasks> shares;
        workers_.each(
            tasks, [&](int task) { shares[task] = sum<count>(share_start(nodes_, task), share_start(nodes_, task + 1), each); });
        std::array<double, count> totals{};
        for (const auto& share : shares) {
            for (int k = 0; k < count; ++k) totals[k] += share[k];
        }
        return totals;
    }

private:
    static constexpr int worth_sharing = 6000;    // nodes: 10 µs a loop
    static constexpr int run = 32;                // nodes

    template <int count, class Each>
    static std::array<double, count> sum(int first, int last, Each& each) {
        std::array<double, count> totals{};
        for (int begin = first; begin < last; begin += run) {
            std::array<Quad, count> parts{};
            for (int i = begin; i < std::min(begin + run, last); ++i) each(i, parts);
            for (int k = 0; k < count; ++k) {
                totals[k] += (double{parts[k][0]} + double{parts[k][1]}) + (double{parts[k][2]} + double{parts[k][3]});
            }
        }
        return totals;
    }

    int nodes_;
    Workers& workers_;
};

}    // namespace stylet::corotational_fem
