#include "mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace stylet::winkler {
namespace {

/// Of any column with a piece of length d on κ.
double bound_of_piece(double d, double kappa) {
    constexpr double four_pi_squared = 4.0 * std::numbers::pi * std::numbers::pi;
    const double best = kappa > 0.0 ? std::sqrt(four_pi_squared / std::sqrt(3.0 * kappa)) : d;    // least bound of all lengths
    const double d_squared = std::min(d, best) * std::min(d, best);
    return four_pi_squared / d_squared + 3.0 * kappa * d_squared / four_pi_squared;
}

}    // namespace

double bound_of_load(const Pieces& pieces) {
    double least = std::numeric_limits<double>::infinity(), stiffest = 0.0, begin = 0.0;
    for (std::size_t i = 0; i < pieces.size; ++i) {
        const auto [end, kappa] = pieces.of[i];
        least = std::min(least, bound_of_piece(end - begin, kappa));
        stiffest = std::max(stiffest, kappa);
        begin = end;
    }
    return std::min(least, bound_of_piece(1.0, stiffest));
}

void share_out(const Pieces& pieces, double bound, int elements, Nodes& nodes) {
    constexpr double deepest = 12.0;    // lengths κ^-¼ into which a shape reaches, at either end a few
    const double of_load = std::sqrt(bound);
    std::array<double, max_pieces> density;    // wave number
    double total = 0.0, begin = 0.0;
    for (std::size_t i = 0; i < pieces.size; ++i) {
        const auto [end, kappa] = pieces.of[i];
        const double of_foundation = std::min(std::sqrt(std::sqrt(kappa)), deepest / (end - begin));
        density[i] = std::max(of_load, of_foundation);
        total += density[i] * (end - begin);
        begin = end;
    }

    std::size_t piece = 0;
    double passed = 0.0;    // of the total, up to the begin of the piece
    begin = 0.0;
    nodes[0] = 0.0;
    for (int n = 1; n < elements; ++n) {
        const double wanted = total * n / elements;
        while (piece + 1 < pieces.size && passed + density[piece] * (pieces.of[piece].end - begin) < wanted) {
            passed += density[piece] * (pieces.of[piece].end - begin);
            begin = pieces.of[piece++].end;
        }
        nodes[static_cast<std::size_t>(n)] = begin + (wanted - passed) / density[piece];
    }
    nodes[static_cast<std::size_t>(elements)] = 1.0;
}

}    // namespace stylet::winkler
