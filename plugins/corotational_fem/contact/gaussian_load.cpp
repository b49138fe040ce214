#include "contact/gaussian_load.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace stylet::corotational_fem {
namespace {

constexpr double root_2_over_pi = std::numbers::sqrt2 * std::numbers::inv_sqrtpi;

// Kelvin's solution averaged over two Gaussians of s² = `variance` together, but for its factor.
Matrix3 full_space(double nu, const Vector3& x, double variance) {
    const double rr = x.squaredNorm(), q = rr / variance, s = std::sqrt(variance), centre = root_2_over_pi / s;
    double half_laplacian, slope;    // ∇²B/2 and B'/R
    constexpr double near = 1e-2;    // the series' next term is 1e-11 there, and the closed form's rounding as little
    if (q < near) {
        half_laplacian = centre * (1.0 - q / 6.0 + q * q / 40.0 - q * q * q / 336.0);
        slope = 2.0 * centre * (1.0 / 3.0 - q / 30.0 + q * q / 280.0 - q * q * q / 3024.0);
    } else {
        const double R = std::sqrt(rr), e = std::erf(std::sqrt(0.5 * q));
        half_laplacian = e / R;
        slope = ((1.0 - 1.0 / q) * e + root_2_over_pi * (s / R) * std::exp(-0.5 * q)) / R;
    }
    const double along = rr > 0.0 ? (3.0 * slope - 2.0 * half_laplacian) / rr : 0.0;
    return (4.0 * (1.0 - nu) * half_laplacian - slope) * Matrix3::Identity() + along * x * x.transpose();
}

// The surface's share of Mindlin's solution, but for its factor: i and j as in u_ij, depths downward.
Matrix3 surface_share(double nu, const GaussianLoad& i, const GaussianLoad& j) {
    const double dx = i.x - j.x, dy = i.y - j.y, rr = dx * dx + dy * dy + i.blur + j.blur;
    const double z = i.depth, c = j.depth, k = 3.0 - 4.0 * nu, m = 4.0 * (1.0 - nu) * (1.0 - 2.0 * nu);
    // horizontal = across·1 + along·x xᵀ
    double across, along, vertical, even = 0.0, odd;
    {    // e^(−ξz) e^(−ξc)
        const double s = z + c, R = std::sqrt(rr + s * s), p = 1.0 / (R + s);
        across = (1.0 + k) / R - (k - m) * p;
        along = (k - m) * p * p / R;
        vertical = (8.0 * (1.0 - nu) * (1.0 - nu) - k) / R;
        odd = -m * p / R;
    }
    const auto once = [&](double depth, double sign, double s) {    // the depth of one of them as a factor
        const double R = std::sqrt(rr + s * s), p = 1.0 / (R + s), i3 = 1.0 / (R * R * R);
        across -= k * depth * p / R;
        along += k * depth * (2.0 * R + s) * i3 * p * p;
        vertical += k * depth * s * i3;
        even += sign * k * depth * i3;
    };
    once(z, 1.0, i.reach + c);
    once(c, -1.0, z + j.reach);
    {    // both
        const double s = i.reach + j.reach, R2 = rr + s * s, R = std::sqrt(R2), i5 = 1.0 / (R2 * R2 * R);
        across += 2.0 * z * c * R2 * i5;
        along -= 6.0 * z * c * i5;
        vertical += 2.0 * z * c * (3.0 * s * s - R2) * i5;
        odd += 6.0 * z * c * s * i5;
    }
    Matrix3 u;    // the world's z goes up: what mixes horizontal and vertical changes its sign
    u << across + along * dx * dx, along * dx * dy, -dx * (even + odd),    //
        along * dx * dy, across + along * dy * dy, -dy * (even + odd),     //
        -dx * (even - odd), -dy * (even - odd), vertical;
    return u;
}

}    // namespace

GaussianLoad::GaussianLoad(const Vector3& centre, double deviation) : x(centre.x()), y(centre.y()) {
    const double z = std::max(0.0, -centre.z()) / deviation;
    const double mean = root_2_over_pi * std::exp(-0.5 * z * z) + z * std::erf(z / std::numbers::sqrt2);
    depth = deviation * mean;
    reach = deviation * (z * z + 1.0) / mean;
    variance = deviation * deviation * (2.0 + z * z + 1.0 - mean * mean) / 3.0;
    blur = deviation * deviation * std::exp(-0.5 * z * z);
}

Matrix3 response(double poisson_ratio, const GaussianLoad& at, const GaussianLoad& source) {
    const double nu = poisson_ratio;
    const Vector3 x(at.x - source.x, at.y - source.y, source.depth - at.depth);
    const double factor = (1.0 + nu) / (8.0 * std::numbers::pi * (1.0 - nu));
    return factor * (full_space(nu, x, at.variance + source.variance) + surface_share(nu, at, source));
}

}    // namespace stylet::corotational_fem
