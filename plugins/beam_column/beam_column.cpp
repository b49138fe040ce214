#include "beam_column.h"

#include "sine_curve.h"

#include <numbers>

namespace stylet::beam_column {

namespace {

constexpr double greatest_slope = std::numbers::pi / 4.0;    // [rad] beyond it Eq. (4) is far from any real column

const SineCurve& curve() {    // a table that all needles share
    static const SineCurve made;
    return made;
}

}    // namespace

BeamColumn::BeamColumn(const Setup& setup) : ColumnNeedle(setup, curve()) {}

const char* BeamColumn::beyond_validity() const {
    if (curve().largest_slope(committed_shortening()) <= greatest_slope) return nullptr;
    return "beyond validity: the needle's slope is over 45°";
}

}    // namespace stylet::beam_column

STYLET_PLUGIN(
    stylet::beam_column::BeamColumn, "beam_column", stylet::no_parameters,
    .summary = "The paper's needle: straight up to its critical load, then a half sine; no limit load",
    .formula =
        "straight: d = 0, N <= P_cr(L)\n"
        "bowed:    d > 0, N = P_cr(L) f(d/L)\n"
        "stored:   U = P_cr(L) L (integral of f from 0 to d/L)\n"
        "d [m] shortening of the free length L [m], N [N] compression, P_cr from `buckling`, f from Eqs. (4) and (5)",
    .source =
        "He, Chen and Tang, section II.D, Eqs. (4) and (5); Bigoni et al. 2015 for the force at the mouth of the track. "
        "Deviation: the stored energy is the integral of the force over d, not the sine's bending energy",
    .validity =
        "End slope up to 45 degrees; a run says when it goes further. Without `buckling` the needle never buckles. Leaves out "
        "a limit load (a real clamped-pinned column carries at most 1.14 P_cr), bending by lateral forces, and inertia")
