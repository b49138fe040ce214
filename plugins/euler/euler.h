#pragma once

#include <stylet/buckling_model.h>

namespace stylet::euler {

/// The load at which an ideal straight elastic column buckles in air.
///
///     P = k·EI/L²,   k = π²/4 clamped-free, π² pinned-pinned, 4.4934² clamped-pinned (tan x = x), 4π² clamped-clamped
///
/// Source: Euler 1757; Timoshenko and Gere, Theory of Elastic Stability (1961), sections 2.1–2.3. He, Chen and Tang's Eq. (1) is
/// the clamped-free one. Deviation: a free length below the needle's radius counts as the radius, so that P stays finite as L →
/// 0. Valid for slender columns (L ≳ 20 r) that carry their load along the axis, stay elastic and touch nothing between their
/// ends. Leaves out shortening, shear, own weight, imperfections and any support from tissue.
class Euler final : public BucklingModel {
public:
    explicit Euler(const Setup&) {}

    double critical_load(const Column& column) const override;
};

}    // namespace stylet::euler
