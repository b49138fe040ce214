// A uniform traction on a rectangle of the surface of an elastic half-space.
#pragma once

#include <stylet/types.h>

namespace stylet::half_space {

/// A rectangle of the surface, its sides along x and y, that shares a force evenly over its area.
struct Rectangle {
    double x, y;              // [m] of its centre
    double half_x, half_y;    // [m] half its sides

    [[nodiscard]] double area() const { return 4.0 * half_x * half_y; }    // [m²]
};

/// Displacement at `x` for a unit force on the rectangle: the mean of MindlinKernel(x, ·), with the blur b [m], over it. Column j
/// is that of a force in direction j, times Young's modulus [m/N per 1/Pa]. A point above the surface counts as on it.
///
/// In closed form. With X, Y from the load to the point, D = depth + b, R² = X² + Y² + D² and Ω = D ln(R + D) − R, MindlinKernel
/// is, on a source at the surface and without its factor (1 + ν)/2π,
///
///     xx: 2/R − ∂²R/∂X² + b ∂²ln(R + D)/∂X² − (1 − 2ν) ∂²Ω/∂X²        xy: the same with ∂²/∂X∂Y, and without 2/R
///     zz: 2(1 − ν)/R + depth·D/R³                                     xz, zx: depth ∂(1/R)/∂X ± (1 − 2ν) ∂ln(R + D)/∂X
///
/// each of which integrates to logarithms and angles at the four corners. Finite everywhere, at corners and edges as well.
/// Source: Love 1929 (vertical), Cerruti 1882 and Dydo and Busby 1995 (horizontal); the blur is ours. Rounding grows as 1e-16
/// R²/area.
[[nodiscard]] Matrix3 response(double poisson_ratio, const Rectangle& loaded, const Vector3& x, double blur);

/// The same without blur, averaged over a second rectangle: how far that moves as a whole. In closed form too, by integrating
/// once more over both; of a square of side s under its own load 0.9464 (1 − ν²)/(E s) along z. Rounding grows as
/// 1e-19 R⁴/(area · area).
[[nodiscard]] Matrix3 mean_response(double poisson_ratio, const Rectangle& loaded, const Rectangle& moved);

}    // namespace stylet::half_space
