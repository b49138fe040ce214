// The paper's needle: a column that stays straight up to its critical load and then bows as a half sine.
#pragma once

#include <stylet/column_needle.h>

namespace stylet::beam_column {

/// A ColumnNeedle on the paper's curve, Eqs. (4) and (5) (sine_curve.h). The stored energy is ∫F dδ, not the sine's bending
/// energy. Eq. (4) gives the shape that is drawn and the bow that is reported, whatever the ends.
///
/// Source: He, Chen, Tang, section II.D; P_cr from the scene's `buckling`, for its declared ends. A scene without `buckling`
/// gives a needle that never buckles. Validity: end slope up to 45°, said when passed. Leaves out a limit load (a real
/// clamped-pinned column carries at most 1.14 P_cr).
class BeamColumn final : public ColumnNeedle {
public:
    explicit BeamColumn(const Setup& setup);

    const char* beyond_validity() const override;
};

}    // namespace stylet::beam_column
