// Eqs. (2) and (3) of He, Chen and Tang, Modeling of Flexible Needle for Haptic Insertion Simulation.
#pragma once

#include <cstdint>
#include <numbers>

namespace stylet {

/// Two readings of one formula. Their effective length 2l stands in both terms of what the paper calculated, and in the first
/// alone of what it prints: a factor 4 is missing there.
enum class FoundationForm : std::uint8_t { printed, consistent };

/// The effective length of the foundation's term as a multiple of l, squared.
[[nodiscard]] constexpr double foundation_factor(FoundationForm form) {
    return form == FoundationForm::printed ? 1.0 : 4.0;
}

/// Eq. (2): the critical load [N] of a column of length l [m] and bending stiffness EI [N·m²], clamped at its base and free at
/// its tip, on springs of stiffness μ [Pa].
///
///     printed:     P = π²EI/4l² + μl²/π²
///     consistent:  P = π²EI/(2l)² + μ(2l)²/π²
///
/// Source: He, Chen and Tang, Eq. (2). Our finding: with μ = 5629, 7793 and 8916 Pa, l = 50 mm and EI = 1.27235e-3 N·m² the
/// printed form gives 2.68, 3.23 and 3.51 N, the consistent one 6.96, 9.15 and 10.29 N; Tables 1 and 2 lie between 6.9 and
/// 10.3 N. Both are the load of a pinned column of the effective length. Neither is that of a clamped-free column on a Winkler
/// foundation, which tends to √(kEI) as it gets long: μ is a number to fit, and for one tissue it changes 13-fold as l goes from
/// 20 to 120 mm.
[[nodiscard]] constexpr double foundation_load(double bending_stiffness, double length, double stiffness, FoundationForm form) {
    constexpr double pi_squared = std::numbers::pi * std::numbers::pi;
    const double l_squared = length * length;
    return pi_squared * bending_stiffness / (4.0 * l_squared) + foundation_factor(form) * stiffness * l_squared / pi_squared;
}

/// Eq. (3), which is Eq. (2) solved for μ [Pa]: the stiffness of the springs that give a column the critical load P [N].
///
///     printed:     μ = π²P/l² − π⁴EI/4l⁴
///     consistent:  a fourth of that
///
/// Source: He, Chen and Tang, Eq. (3). Our finding: the stiffnesses of Tables 1 and 2 are the consistent form's, to the last
/// digit.
[[nodiscard]] constexpr double foundation_stiffness(double bending_stiffness, double length, double load, FoundationForm form) {
    constexpr double pi_squared = std::numbers::pi * std::numbers::pi;
    const double l_squared = length * length;
    const double of_tissue = load - pi_squared * bending_stiffness / (4.0 * l_squared);    // [N]
    return pi_squared * of_tissue / (foundation_factor(form) * l_squared);
}

}    // namespace stylet
