#pragma once

#include <stylet/setup.h>

namespace stylet::study {

inline constexpr double furthest_shortening = 0.99;    // of the length: at 1 the ends meet

/// The load of an inextensible, unshearable column in air whose ends have come nearer, over the load at which it buckles:
/// P/P_cr at a shortening `d` [of its length] in its first mode; NaN outside 0 < d ≤ furthest_shortening.
///
/// Pinned-pinned, clamped-clamped and clamped-free (two, four and one quarter waves of length l between a largest slope α and a
/// straight point), with k = sin(α/2):
///
///     d = 2 − 2E(k)/K(k),   P/P_cr = (2K(k)/π)²
///
/// Clamped-pinned: the thrust F leans by β against the axis, as the pin pushes sideways. Along the arc the slope against the
/// thrust is that of a pendulum, sin(ψ/2) = k sn(u), from ψ = β at the clamp (u₀ = F(φ₀, k), sin φ₀ = sin(β/2)/k) to the
/// inflection at the pin, u = 3K. With L√(F/EI) = 3K − u₀ and, in these units, the way along and across the thrust
///
///     ξ = 2(3E − E(φ₀, k)) − (3K − u₀),   η = 2k cos φ₀,   the pin on the axis: η cos β = ξ sin β,
///     d = 1 − (ξ cos β + η sin β)/(3K − u₀),   P/P_cr = (3K − u₀)² cos β / 20.1907
///
/// Source: Love 1927, Theory of Elasticity, §§ 262-263; Timoshenko and Gere 1961, section 2.7; for a clamp and a pin
/// Mikata 2007 (Acta Mech. 190). As d → 0 it tends to 1; at d = 0 the straight column carries any load from 0 to P_cr.
/// Clamped-pinned it is greatest, 1.1396, at d = 0.454, and a pull beyond d = 0.81. Leaves out that the column may touch itself.
[[nodiscard]] double elastica_load(Ends ends, double d);

/// P_cr L²/EI of a straight column in air: π²/4, π², 20.1907 (the first root of tan q = q, squared), 4π². Euler 1757.
[[nodiscard]] double euler_factor(Ends ends);

}    // namespace stylet::study
