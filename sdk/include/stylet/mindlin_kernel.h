// Mindlin's point load inside an elastic half-space, blurred to the size of a needle.
#pragma once

#include <stylet/types.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace stylet {

/// Displacement at one point of an elastic half-space (z ≤ 0, free surface z = 0) for a unit force at another [m/N per 1/Pa].
///
/// Mindlin (1936) with the force spread over the horizontal plane through its point. In horizontal Hankel space the spread is the
/// factor e^(−ξb); as every term of Mindlin's solution is a harmonic function of |z − c| or z + c, the factor only moves them:
/// |z − c| → |z − c| + b and z + c → z + c + b inside the distances. With b = 2a/π a vertical force on the surface meets exactly
/// the rigid punch of radius a, (1 − ν²)/(2aE); a horizontal one (2 − ν)/(8Ga); deep inside, (3 − 4ν)/(32G(1 − ν)a) is the
/// embedded rigid disc (Selvadurai 1976). Multiplying by a positive factor per wave number keeps the kernel symmetric and
/// positive definite. Deviation from Mindlin: the spread itself; a few radii away the two agree to O(a/R).
class MindlinKernel {
public:
    /// `radius` a of the needle [m].
    MindlinKernel(double poisson_ratio, double radius)
        : nu_(poisson_ratio),
          blur_(2.0 * radius / std::numbers::pi),
          scale_((1.0 + poisson_ratio) / (8.0 * std::numbers::pi * (1.0 - poisson_ratio))) {}

    [[nodiscard]] double blur() const { return blur_; }    // [m]

    /// Column j is the displacement at `x` for a unit force in direction j at `source`, times Young's modulus. Points above the
    /// surface count as on it.
    [[nodiscard]] Matrix3 operator()(const Vector3& x, const Vector3& source) const {
        const double z = depth(x), c = depth(source);
        const double d = std::abs(z - c) + blur_, s = z + c + blur_;    // Z1', Z2'
        const double dx = x.x() - source.x(), dy = x.y() - source.y();
        const double rr = dx * dx + dy * dy;
        if (rr == 0.0) return on_one_vertical(z, c, d, s);
        const double R1 = std::sqrt(rr + d * d), R2 = std::sqrt(rr + s * s);
        const double i1 = 1.0 / R1, i2 = 1.0 / R2;
        const double i1_3 = i1 * i1 * i1, i2_3 = i2 * i2 * i2, i2_5 = i2_3 * i2 * i2;
        const double k = 3.0 - 4.0 * nu_, m = 4.0 * (1.0 - nu_) * (1.0 - 2.0 * nu_), cz = c * z;
        const double p1 = 1.0 / (R1 + d), p2 = 1.0 / (R2 + s);

        const double vertical = k * i1 + (d - blur_) * d * i1_3 + (8.0 * (1.0 - nu_) * (1.0 - nu_) - k) * i2 +
                                k * (s - blur_) * s * i2_3 + 2.0 * cz * (3.0 * s * s - R2 * R2) * i2_5;
        const double even = (z - c) * i1_3 + k * (z - c) * i2_3;
        const double odd = 6.0 * cz * s * i2_5 - m * i2 * p2;
        // horizontal = across·1 + along·x xᵀ
        const double across = k * i1 + blur_ * i1 * p1 + i2 + k * blur_ * i2 * p2 + 2.0 * cz * i2_3 + m * p2;
        const double along = i1_3 - blur_ * (2.0 * R1 + d) * i1_3 * p1 * p1 +
                             k * (i2_3 - blur_ * (2.0 * R2 + s) * i2_3 * p2 * p2) - 6.0 * cz * i2_5 - m * i2 * p2 * p2;

        // The formulas count depth downward; the world's z goes up, so what mixes horizontal and vertical changes its sign.
        Matrix3 u;
        u << across + along * dx * dx, along * dx * dy, -dx * (even + odd),    //
            along * dx * dy, across + along * dy * dy, -dy * (even + odd),     //
            -dx * (even - odd), -dy * (even - odd), vertical;
        return scale_ * u;
    }

private:
    /// The same where R1' = d and R2' = s: no root to draw, and nothing couples horizontal with vertical. Most tracks are
    /// vertical.
    [[nodiscard]] Matrix3 on_one_vertical(double z, double c, double d, double s) const {
        const double k = 3.0 - 4.0 * nu_, m = 4.0 * (1.0 - nu_) * (1.0 - 2.0 * nu_), cz = c * z;
        const double i1 = 1.0 / d, i2 = 1.0 / s, i2_2 = i2 * i2, i2_3 = i2_2 * i2;
        const double vertical = k * i1 + (d - blur_) * i1 * i1 + (8.0 * (1.0 - nu_) * (1.0 - nu_) - k) * i2 +
                                k * (s - blur_) * i2_2 + 4.0 * cz * i2_3;
        const double across = k * i1 + 0.5 * blur_ * i1 * i1 + i2 + 0.5 * k * blur_ * i2_2 + 2.0 * cz * i2_3 + 0.5 * m * i2;
        return scale_ * Vector3(across, across, vertical).asDiagonal().toDenseMatrix();
    }

    static double depth(const Vector3& x) { return std::max(0.0, -x.z()); }

    double nu_;
    double blur_;     // [m] b = 2a/π
    double scale_;    // E/(16πG(1 − ν))
};

}    // namespace stylet
