// How far one point of an elastic space moves for a force at another.
#pragma once

#include <stylet/types.h>

#include <cmath>
#include <numbers>

namespace stylet::viscoelastic_half_space {

/// Displacement in an elastic space of Young's modulus 1 for a unit force that is spread over a small ball [1/m]: with
/// a = (1 + ν)/(2π), b = a/(4(1 − ν)) and R² = r² + ε²,
///
///     K(r) = ((a − b)/R + aε²/(2R³)) 1 + b/R³ r rᵀ
///
/// Source: de Goes and James 2017, "Regularized Kelvinlets", eq. (6): Kelvin's point load, its force smeared out by a weight of
/// positive spectrum, hence symmetric and positive definite between any points. Deviation: the ball is so large that the contact
/// itself meets the rigid punch of the needle's radius on a half-space, K(0) = (1 − ν²)/(2 radius) 1.
class Kernel {
public:
    Kernel(double poisson_ratio, double radius)
        : a_((1.0 + poisson_ratio) / (2.0 * std::numbers::pi)),
          b_(a_ / (4.0 * (1.0 - poisson_ratio))),
          ball_((1.5 * a_ - b_) * 2.0 * radius / (1.0 - poisson_ratio * poisson_ratio)) {}

    /// `r` [m] from the force to the point.
    [[nodiscard]] Matrix3 operator()(const Vector3& r) const {
        const double R = std::sqrt(r.squaredNorm() + ball_ * ball_), R3 = R * R * R;
        return ((a_ - b_) / R + 0.5 * a_ * ball_ * ball_ / R3) * Matrix3::Identity() + b_ / R3 * r * r.transpose();
    }

private:
    double a_, b_;
    double ball_;    // [m] ε
};

}    // namespace stylet::viscoelastic_half_space
