// The exact shape of a bowed column: an arc of the inflectional elastica, by elliptic functions.
#pragma once

#include <stylet/column_curve.h>
#include <stylet/setup.h>

namespace stylet::elastica {

/// An inextensible column of unit length and unit bending stiffness, bowed in a plane by forces at its two ends. Its angle φ to
/// the end force swings along it like a pendulum (Kirchhoff), φ'' = −λ² sin φ:
///
///     sin(φ/2) = k sn u,   φ' = 2kλ cn u,   u = u₀ + λs                                     modulus k = sin(α/2)
///     X = (2(E(am u) − E(am u₀)) − λs)/λ,   Y = −2k (cn u − cn u₀)/λ                        along and across the force
///
/// α is the largest φ, s the arc from the base. The force is λ², its part along the line between the ends N = λ² cos ψ, with ψ
/// the angle from the force to that line. The ends say which arc it is:
///
///     pinned-pinned      u₀ = K,   λ = 2K,   ψ = 0       no bending at its ends (cn = 0)
///     clamped-free       u₀ = 0,   λ = K,    ψ = 0       half of a pinned-pinned one
///     clamped-clamped    u₀ = 0,   λ = 4K,   ψ = 0       four of these
///     clamped-pinned     u₀ = 3K − λ,   ψ = φ(u₀)        λ such that the pin is on the line, Y cos ψ = X sin ψ
///
/// Source: Love 1927, A Treatise on the Mathematical Theory of Elasticity, sections 262 and 263; Timoshenko and Gere 1961,
/// section 2.7.
class Arc {
public:
    /// 0 ≤ k < 1, λ > 0. Any λ makes an arc, but only that which leaves no misfit belongs to these ends.
    Arc(Ends ends, double modulus, double length);

    /// λ less than it should be; of a clamped-pinned column how far its pin is off the line, over k > 0.
    [[nodiscard]] double misfit() const;

    /// 0 ≤ arc ≤ 1.
    [[nodiscard]] BowPoint at(double arc) const;

    [[nodiscard]] double shortening() const { return 1.0 - at(1.0).along; }    // η
    [[nodiscard]] double load() const;                                         // N, over EI/L²
    [[nodiscard]] double energy() const;                                       // ∫ ½φ'² ds, over EI/L

    /// Largest distance from the line, and largest angle to it [rad], of a column that is still pressed (N ≥ 0).
    [[nodiscard]] double deflection() const;
    [[nodiscard]] double largest_slope() const;

private:
    Ends ends_;
    double modulus_;     // k
    double quarter_;     // K(k)
    double length_;      // λ
    double first_;       // u₀
    double turn_;        // ψ
    double first_cn_;    // cn u₀
    double first_E_;     // E(am u₀)
};

}    // namespace stylet::elastica
