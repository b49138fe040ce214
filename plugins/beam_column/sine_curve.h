// How the paper's buckled column carries load: Eqs. (4) and (5) without dimensions.
#pragma once

#include <stylet/column_curve.h>

namespace stylet::beam_column {

/// A column bowed as a half sine.
///
///     f = (2K(sin α/2)/π)²                      Eq. (5), α the slope at the ends, P_cr the load of the declared ends
///     1 − η = π cos α / (2E(sin α))             Eq. (4)'s half sine with the span that keeps the length (inextensible)
///
/// K and E are the complete elliptic integrals (Boost.Math). Tabulated once as cubic Hermite pieces. f starts at 1 with slope
/// 1/2 and reaches 1.393 at α = 90°: it never falls, this column has no limit load. It is folded flat at 89°. Source: He, Chen,
/// Tang, Eqs. (4), (5). Deviation: the paper gives no span; ours is inextensible.
class SineCurve final : public ColumnCurve {
public:
    SineCurve();

    double own_factor() const override;
    BowPoint bow(double shortening, double arc) const override;
    double deflection(double shortening) const override { return amplitude(largest_slope(shortening)); }
    double largest_slope(double shortening) const override;

    /// The half sine's amplitude over the length: sin α / (2E(sin α)).
    [[nodiscard]] static double amplitude(double end_slope);

private:
    HermiteTable square_;    // α² over η: smooth at η = 0, where α itself is not
};

}    // namespace stylet::beam_column
