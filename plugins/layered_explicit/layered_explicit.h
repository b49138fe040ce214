#pragma once

#include <stylet/foundation.h>

namespace stylet::layered_explicit {

/// An explicit equation for the critical load of a clamped-free needle in layered tissue: Rayleigh and Ritz in two or three of
/// the functions φⱼ = 1 − cos αⱼξ, αⱼ = (2j − 1)π/2, ξ = x/l from base to tip.
///
///     P = p EI/l²,   p the smallest root of det(A − p) = 0,
///     Aᵢⱼ = αᵢ² δᵢⱼ + 2/(αᵢαⱼ) Σ κ ∫ φᵢφⱼ dξ,   κ = k l⁴/EI of each piece,   the integral over the piece
///
/// which is a quadratic for two terms and a cubic for three: the φⱼ are orthogonal in bending and in shortening, and the layers
/// come in by exact integrals. With one piece, κ everywhere: A = diag(αᵢ²) + κ (2/αᵢαⱼ)(1 + δᵢⱼ/2 − sin αᵢ/αᵢ − sin αⱼ/αⱼ).
///
/// Source: ours, for the equation that He, Chen and Tang leave to future work. An upper bound of the load of `winkler` with the
/// same foundation, never below Euler's. With l (k/EI)^¼ of the stiffest layer up to 5, two terms are within 5 % and three within
/// 1.4 %; at 7 within 43 and 5 %; at 10 up to 210 and 25 % too high. A length below the needle's radius counts as the radius.
/// Only for a needle that is clamped at its base and free at its tip, and every column is taken for one: held at its tip it
/// buckles in many waves, which a few terms are not.
class LayeredExplicit final : public BucklingModel {
public:
    /// Throws Error where the scene's needle has other ends.
    explicit LayeredExplicit(const Setup& setup);

    double critical_load(const Column& column) const override;

private:
    Foundation foundation_;
    std::int64_t terms_;    // 2 or 3
};

}    // namespace stylet::layered_explicit
