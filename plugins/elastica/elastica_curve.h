// The load of a bowed elastica against its shortening, tabulated.
#pragma once

#include "arc.h"

#include <stylet/column_curve.h>
#include <stylet/setup.h>

namespace stylet::elastica {

/// The exact, inextensible, planar curve of a column after it has buckled (arc.h), as cubic pieces over the shortening η.
///
/// Pinned-pinned, clamped-free and clamped-clamped columns are made of the same quarters and share one load, f = (2K/π)² at
/// η = 2 − 2E/K: it starts at 1 with slope 1/2 and is 2.183 where the two ends have come level (η = 1, α = 130.7°): there the
/// column stops. That of a clamped-pinned column starts with slope 0.376 and is largest at η = 0.454: 1.1396, its limit load.
/// From there it falls, ever faster, and stops at η = 0.812, where it is 0.001: hardly further on it would have to be pulled, but
/// let go it springs open.
class ElasticaCurve final : public ColumnCurve {
public:
    explicit ElasticaCurve(Ends ends);

    double own_factor() const override;
    BowPoint bow(double shortening, double arc) const override { return this->arc(shortening).at(arc); }
    double deflection(double shortening) const override;
    double largest_slope(double shortening) const override;
    double end_aside(double shortening) const override;

    /// The shortening at which the column meets itself: a clamped-clamped one's bulges do before it is folded, no other does.
    [[nodiscard]] double touches_itself() const;

    /// One made once for all needles with these ends.
    [[nodiscard]] static const ElasticaCurve& of(Ends ends);

private:
    struct Tables {
        HermiteTable square, length, load, deflection, slope;    // over η: k², λ, f, the squares of the last two
    };
    ElasticaCurve(Ends ends, Tables tables);
    static Tables tabulate(Ends ends);
    [[nodiscard]] Arc arc(double shortening) const;

    Ends ends_;
    HermiteTable square_, length_, deflection_, slope_;
};

}    // namespace stylet::elastica
