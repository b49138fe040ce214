#include "lowest_root.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace stylet::layered_explicit {

double lowest_root(double a, double b, double c) {
    return (a * c - b * b) / (0.5 * (a + c) + std::hypot(0.5 * (a - c), b));
}

double lowest_root(const Matrix3& matrix) {
    const double mean = matrix.trace() / 3.0;
    const Matrix3 deviator = matrix - mean * Matrix3::Identity();
    const double spread = std::sqrt(deviator.squaredNorm() / 6.0);
    if (!(spread > 0.0)) return mean;
    const double half_determinant = 0.5 * (deviator / spread).determinant();
    const double angle = std::acos(std::clamp(half_determinant, -1.0, 1.0)) / 3.0;
    return mean + 2.0 * spread * std::cos(angle + 2.0 * std::numbers::pi / 3.0);
}

}    // namespace stylet::layered_explicit
