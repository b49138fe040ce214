#pragma once

#include "chain.h"

#include <array>

namespace stylet::rod {

/// A material point of the rod between its nodes: a cubic through the four nodes around it, smooth where pieces meet (Catmull and
/// Rom 1974), so that a contact that slides along feels no edges. Linear in the nodes' displacements,
///
///     u(s) = Σ w u_node      u'(s) = Σ w' u_node
///
/// and a straight rod is met exactly. Beyond the ends stand mirrored nodes: the clamp's direction, a pin, a free tip go on.
struct Spot {
    static constexpr int most = 4;
    int first = 1;                         // node of the first weight; the base itself never moves
    int count = 0;                         // of nodes
    std::array<double, most> weights{};    // [1]
    std::array<double, most> slopes{};     // [1/m]

    /// `arclength` [m] from the base; beyond the ends it is the end.
    [[nodiscard]] static Spot at(const Chain& chain, double arclength);

    [[nodiscard]] Vector3 displacement(const Shape& shape) const { return sum(shape, weights); }    // [m]
    [[nodiscard]] Vector3 slope(const Shape& shape) const { return sum(shape, slopes); }            // [1] of the displacement

private:
    [[nodiscard]] Vector3 sum(const Shape& shape, const std::array<double, most>& factors) const {
        Vector3 total = Vector3::Zero();
        for (int i = 0; i < count; ++i) total += factors[i] * shape.displacement[first + i];
        return total;
    }
};

}    // namespace stylet::rod
