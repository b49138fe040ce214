// How a buckled column carries load: the paper's Eqs. (4) and (5) without dimensions.
#pragma once

#include <vector>

namespace stylet::beam_column {

/// Everything about a bowed column at one shortening η = δ/l.
struct CurvePoint {
    double load;      // f = F/P_cr
    double slope;     // df/dη
    double energy;    // ∫₀^η f dη
};

/// The load of a bowed column against its shortening.
///
///     f = (2K(sin α/2)/π)²                      Eq. (5), α the slope at the ends, P_cr the load of the declared ends
///     1 − η = π cos α / (2E(sin α))             Eq. (4)'s half sine with the span that keeps the length (inextensible)
///
/// K and E are the complete elliptic integrals (Boost.Math). Tabulated once as cubic Hermite pieces; the energy integrates the
/// same pieces exactly, so force and energy agree to rounding. f starts at 1 with slope 1/2 and reaches 1.393 at α = 90°: it
/// never falls, this column has no limit load. Source: He, Chen, Tang, Eqs. (4), (5). Deviation: the paper gives no span; ours is
/// inextensible.
class ColumnCurve {
public:
    ColumnCurve();

    /// 0 ≤ η; beyond the last tabulated slope (89°) the column is folded flat and stops.
    [[nodiscard]] CurvePoint at(double shortening) const;

    /// The slope at the ends α [rad].
    [[nodiscard]] double end_slope(double shortening) const;

    /// The half sine's amplitude over the length: sin α / (2E(sin α)).
    [[nodiscard]] static double amplitude(double end_slope);

private:
    // One end of a cubic piece.
    struct Knot {
        double load, load_slope;        // f, df/dη
        double square, square_slope;    // α², dα²/dη: smooth at η = 0, where α itself is not
        double energy;                  // ∫ f
    };

    std::vector<Knot> knots_;
    double step_;    // in η
};

}    // namespace stylet::beam_column
