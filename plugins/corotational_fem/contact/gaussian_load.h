// An elastic half-space under a force spread as wide as a few tetrahedra: what a mesh answers to a contact.
#pragma once

#include <stylet/types.h>

namespace stylet::corotational_fem {

/// A unit force spread about a point of a half-space (z ≤ 0) as a Gaussian; what would lie above the surface is folded back
/// below.
struct GaussianLoad {
    GaussianLoad() = default;

    /// `centre` [m], one above the surface counts as on it; `deviation` σ [m] along each axis, more than zero.
    GaussianLoad(const Vector3& centre, double deviation);

    double x = 0.0, y = 0.0;    // [m]
    double depth = 0.0;         // [m] ⟨|z|⟩
    double reach = 0.0;         // [m] ⟨z²⟩/⟨|z|⟩
    double variance = 0.0;      // [m²] along an axis, the mean of three
    double blur = 0.0;          // [m²] what the surface's share is blurred by
};

/// Mean displacement over the load `at` for the load `source`; column j is that for a force in direction j, times Young's modulus
/// [m/N per 1/Pa]. Symmetric: the transpose with the loads exchanged.
///
/// Full space has a closed form. Kelvin's solution is (1 + ν)/(8π(1 − ν)) [2(1 − ν) ∇²B − ∇∇B] with B = R, and averaging over two
/// Gaussians leaves B = (R + s²/R) erf(R/√2s) + √(2/π) s e^(−R²/2s²), s² = σ² + σ'². It differs from a point load's by no more
/// than O(s²/R³), so that loads far from each other need no correction.
///
/// The surface's share is Mindlin's (1936), whose terms in horizontal Hankel space are (ξz)^p (ξc)^q e^(−ξ(z + c)), p and q 0
/// or 1. Averaged over a spread, ⟨e^(−ξz)⟩ is e^(−ξ·depth) and ⟨ξz e^(−ξz)⟩ is ξ·depth e^(−ξ·reach), right to the first two
/// moments; what is left of the horizontal spread, which far below the surface the vertical one makes up for exactly, is added to
/// R². Source: ours.
///
/// Accuracy beside the mean of Mindlin's solution over two folded balls with density (1 − r²/ρ²)², ρ = 3σ, ν from 0.3 to 0.49, as
/// a share of the whole matrix: within 8 % anywhere, 4 % for a load below ρ on itself, 2.5 % for two that are 2ρ apart.
[[nodiscard]] Matrix3 response(double poisson_ratio, const GaussianLoad& at, const GaussianLoad& source);

}    // namespace stylet::corotational_fem
