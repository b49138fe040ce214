// A needle as an exact column: straight up to its critical load, then the elastica of its ends.
#pragma once

#include "elastica_curve.h"

#include <stylet/column_needle.h>

namespace stylet::elastica {

/// A ColumnNeedle on the exact curve of its declared ends (elastica_curve.h). P_cr is the elastica's own first bifurcation,
/// k EI/L², unless the scene names a `buckling`, whose load then scales the curve. The stored energy is the bending energy of the
/// shape.
///
/// A clamped-pinned needle has a limit load, 1.1396 P_cr: a bow beyond it carries less the further it goes. Under a load that it
/// cannot carry it folds up to the stop.
///
/// Clamped-free ends bend as if the tip slid across the tissue without friction: the tip that is drawn, and the deflection, go
/// aside; its contacts, and the inserted part, stay on the needle's line.
///
/// Validity, said when passed: a slope over 90° where there is tissue (the bow would lie on it), a bow that meets itself, the
/// stop. Leaves out yielding, bending by lateral forces, leaving the plane, inertia.
class Elastica final : public ColumnNeedle {
public:
    explicit Elastica(const Setup& setup);

    const char* beyond_validity() const override;

private:
    const ElasticaCurve& curve_;
    bool over_tissue_;
};

}    // namespace stylet::elastica
