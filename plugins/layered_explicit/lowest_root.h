#pragma once

#include <stylet/types.h>

namespace stylet::layered_explicit {

/// The smaller eigenvalue of the symmetric matrix (a b; b c), the smaller root of its quadratic.
///
///     λ = (ac − b²)/(m + √(((a − c)/2)² + b²)),   m = (a + c)/2 > 0
[[nodiscard]] double lowest_root(double a, double b, double c);

/// The smallest eigenvalue of a symmetric 3 × 3 matrix, the smallest root of its cubic. Source: Smith 1961, Eigenvalues of a
/// symmetric 3 × 3 matrix (trigonometric solution). Exact to a few roundings of the largest eigenvalue.
[[nodiscard]] double lowest_root(const Matrix3& matrix);

}    // namespace stylet::layered_explicit
