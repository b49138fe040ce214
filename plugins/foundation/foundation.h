#pragma once

#include <stylet/foundation.h>
#include <stylet/foundation_equation.h>

namespace stylet::foundation {

/// Eq. (2) of He, Chen and Tang: the load at which a column in homogeneous tissue buckles.
///
///     printed:     P = π²EI/4l² + s μl²/π²
///     consistent:  P = π²EI/(2l)² + s μ(2l)²/π²
///
/// l [m] base to tip; μ [Pa] of the layer that the tip is in, because the tissue at the free end governs (their section II C); s
/// the share of ∫w² that the part in tissue has in the shape w = 1 − cos(πx/2l) of Eq. (1): 1 where all of the needle is in, 0
/// where none is. Source: He, Chen and Tang, Eq. (2); see foundation_equation.h for what the printed form leaves out. Deviations:
/// s, so that the load stays continuous while the needle goes in; a length below the needle's radius counts as the radius. Valid
/// for a μ that was fitted to a column of this length by Eq. (3). The load jumps where the tip enters another layer. Only for a
/// needle that is clamped at its base and free at its tip: every column is taken for one.
class FoundationFormula final : public BucklingModel {
public:
    /// Throws Error where the scene's needle has other ends.
    explicit FoundationFormula(const Setup& setup);

    double critical_load(const Column& column) const override;

private:
    Foundation foundation_;
    FoundationForm form_;
};

}    // namespace stylet::foundation
