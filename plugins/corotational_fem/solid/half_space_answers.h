// What a half-space does under a load on its surface z = 0, in closed form.
#pragma once

#include <stylet/types.h>

#include <cmath>
#include <numbers>

namespace stylet::corotational_fem::testing {

/// Displacement [m] at x, z ≤ 0, of a force [N] straight down at the origin. Source: Boussinesq 1885; Johnson 1985, eq. 3.18.
inline Vector3 boussinesq(const Vector3& x, double force, double youngs_modulus, double poisson_ratio) {
    const double distance = x.norm(), depth = -x.z();
    const double unit = force * (1.0 + poisson_ratio) / (2.0 * std::numbers::pi * youngs_modulus * distance);    // F/(4πG ρ)
    const double outward = depth / (distance * distance) - (1.0 - 2.0 * poisson_ratio) / (distance + depth);     // [1/m]
    const double down = 2.0 * (1.0 - poisson_ratio) + depth * depth / (distance * distance);
    return unit * Vector3(outward * x.x(), outward * x.y(), -down);
}

/// The same of a force spread evenly over the square |x|, |y| ≤ side/2, some sides away from it: a sum over 8 × 8 of its points,
/// which is off by a few parts in ten thousand at one side from the middle and less farther out.
inline Vector3 far_from_square(const Vector3& x, double side, double force, double youngs_modulus, double poisson_ratio) {
    constexpr int across = 8;
    Vector3 sum = Vector3::Zero();
    for (int i = 0; i < across; ++i) {
        for (int j = 0; j < across; ++j) {
            const Vector3 at(((i + 0.5) / across - 0.5) * side, ((j + 0.5) / across - 0.5) * side, 0.0);
            sum += boussinesq(x - at, force / (across * across), youngs_modulus, poisson_ratio);
        }
    }
    return sum;
}

/// By how much such a square sinks on average [m]. Source: Love 1929; Timoshenko and Goodier 1970, article 139.
inline double mean_sink_of_square(double side, double force, double youngs_modulus, double poisson_ratio) {
    const double root = std::sqrt(2.0);
    const double factor = 4.0 / std::numbers::pi * (std::log(1.0 + root) + (1.0 - root) / 3.0);    // 0.9464
    return factor * force * (1.0 - poisson_ratio * poisson_ratio) / (youngs_modulus * side);
}

}    // namespace stylet::corotational_fem::testing
