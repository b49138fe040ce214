#include "spot.h"

#include <algorithm>

namespace stylet::rod {

namespace {

// Onto which nodes the weight of a node beyond an end falls.
void fold(const Chain& chain, int node, double weight, double slope, Spot& spot) {
    const auto add = [&](int to, double factor) {
        if (to == 0) return;    // the base stays
        spot.weights[to - spot.first] += factor * weight;
        spot.slopes[to - spot.first] += factor * slope;
    };
    if (node < 0) {
        add(1, chain.setup().clamped ? 1.0 : -1.0);
    } else if (node > chain.edges()) {
        add(chain.edges(), 2.0);
        add(chain.edges() - 1, -1.0);
    } else {
        add(node, 1.0);
    }
}

}    // namespace

Spot Spot::at(const Chain& chain, double arclength) {
    const double along = std::clamp(arclength / chain.edge_length(), 0.0, static_cast<double>(chain.edges()));
    const int edge = std::min(static_cast<int>(along), chain.edges() - 1);
    const double t = along - edge, t2 = t * t, t3 = t2 * t, per_length = 1.0 / chain.edge_length();
    const std::array<double, most> weights{-0.5 * t + t2 - 0.5 * t3, 1.0 - 2.5 * t2 + 1.5 * t3, 0.5 * t + 2.0 * t2 - 1.5 * t3,
                                           -0.5 * t2 + 0.5 * t3};
    const std::array<double, most> slopes{-0.5 + 2.0 * t - 1.5 * t2, -5.0 * t + 4.5 * t2, 0.5 + 4.0 * t - 4.5 * t2,
                                          -t + 1.5 * t2};
    Spot spot;
    spot.first = std::clamp(edge - 1, 1, std::max(1, chain.edges() - 2));
    spot.count = std::min(edge + 2, chain.edges()) - spot.first + 1;
    for (int i = 0; i < most; ++i) fold(chain, edge - 1 + i, weights[i], per_length * slopes[i], spot);
    return spot;
}

}    // namespace stylet::rod
