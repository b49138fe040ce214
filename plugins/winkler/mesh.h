#pragma once

#include "banded_pencil.h"

#include <stylet/foundation.h>

namespace stylet::winkler {

/// Lengths are fractions of the column's, loads multiples of EI/length²; κ = k length⁴/EI.
inline constexpr std::size_t max_pieces = max_foundation_layers + 3;    // those of a Foundation and what is left of the length

struct Piece {
    double end;      // from the base
    double kappa;    // zero in air
};

/// A column's pieces from base (0) to tip (1).
struct Pieces {
    std::array<Piece, max_pieces> of;
    std::size_t size = 0;
};

/// Ends of elements, from 0 to 1.
using Nodes = std::array<double, max_elements + 1>;

/// An upper bound of the critical load, whatever the ends: the load of a shape in one piece alone, or of one in the whole column
/// on its stiffest piece, w = 1 − cos 2πx/d with the d that suits it best.
///
///     p ≤ 4π²/d² + 3κd²/4π²
[[nodiscard]] double bound_of_load(const Pieces& pieces);

/// Shares `elements` out so that each spans about the same part of a wave: where the foundation is κ, a load p bends the column
/// in waves and exponentials of wave numbers up to max(√p, κ^¼); for p stands its `bound`. A piece too stiff for such waves,
/// which a shape reaches into no further than a few κ^-¼, gets no more elements for being longer. The nodes move continuously
/// with the pieces, so the load does too; a piece may end anywhere inside an element.
void share_out(const Pieces& pieces, double bound, int elements, Nodes& nodes);

}    // namespace stylet::winkler
