// Nodal vectors in single precision, and sums over them.
#pragma once

#include "fast/lanes.h"

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

/// `count` sums over the nodes at once: each(i, sums) adds node i's part to each of them. Single precision over runs of a few
/// nodes, double from there on, always in the same order.
template <int count, class Each>
std::array<double, count> node_sums(int nodes, Each&& each) {
    constexpr int run = 32;
    std::array<double, count> totals{};
    for (int begin = 0; begin < nodes; begin += run) {
        std::array<Quad, count> parts{};
        const int end = begin + run < nodes ? begin + run : nodes;
        for (int i = begin; i < end; ++i) each(i, parts);
        for (int k = 0; k < count; ++k) {
            totals[k] += (double{parts[k][0]} + double{parts[k][1]}) + (double{parts[k][2]} + double{parts[k][3]});
        }
    }
    return totals;
}

}    // namespace stylet::corotational_fem
