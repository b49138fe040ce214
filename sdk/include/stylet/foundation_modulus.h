// From a layer of tissue to the modulus k [Pa] of a Winkler foundation: newtons a metre of shaft for a metre of deflection.
#pragma once

#include <stylet/buckling_model.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace stylet {

/// The modulus of an elastic half-space under a long beam that lies on it [Pa].
///
///     k = 0.65 (E d⁴/EI)^(1/12) E/(1 − ν²)          (E, ν of the layer, d the needle's diameter, EI its bending stiffness)
///
/// Source: Vesic 1961, Bending of beams resting on isotropic elastic solid. Valid for a beam on the surface. A needle inside has
/// tissue all around and is held 3 to 3.5 times as hard (0.3 mm in radius, EI = 1.27e-3 N·m², in 30 kPa).
[[nodiscard]] inline double vesic_modulus(const Layer& layer, const Column& column) {
    const double diameter = 2.0 * column.radius;    // [m]
    const double ratio = layer.youngs_modulus * std::pow(diameter, 4) / column.bending_stiffness;
    return 0.65 * std::pow(ratio, 1.0 / 12.0) * layer.youngs_modulus / (1.0 - layer.poisson_ratio * layer.poisson_ratio);
}

/// The conformal radius about its centre of a rectangle of these sides [m], for disc_modulus where all four are held: 1.0787 half
/// sides for a square.
///
///     ln b = ln(4a/π) − 2 Σ (−1)ⁿ ln tanh(n π c/2a),   n = 1, 2, …         (a ≤ c half sides)
///
/// Source: the Green's function of a strip, −ln|tanh(π z/4a)|, and its images in the two other sides. Deviation: exact for a
/// scalar, not for two components. Beside plane finite elements (disc of 0.06 a; ν = 0, 0.3, 0.45, 0.49) the modulus is within
/// 0.8 % for a square; of a longer rectangle's weaker direction it is up to 10 % too stiff at 2 : 1 and up to 19 % beyond.
[[nodiscard]] inline double conformal_radius(double side, double other_side) {
    const double a = 0.5 * std::min(side, other_side), c = 0.5 * std::max(side, other_side);
    double logarithm = std::log(4.0 * a / std::numbers::pi);
    for (int n = 1; n <= 12; ++n) {    // the terms fall by at least 23 each: the last is below rounding
        const double image = std::log(std::tanh(0.5 * n * std::numbers::pi * c / a));
        logarithm += (n % 2 == 1 ? 2.0 : -2.0) * image;
    }
    return std::exp(logarithm);
}

/// The same where only two opposite sides of a square are held and the disc moves along them, as in Fig. 5 of He, Chen and Tang;
/// `half_side` [m], ν ≥ 0.
///
///     ln(b/a) = (2.785 + 5.6 d² − 4 d³)/(3 − 4ν),   d = ½ − ν
///
/// Source: ours, fitted to plane finite elements (discs of 0.06 a and 0.03 a, ν from 0 to 0.499): the modulus is within 0.3 %,
/// 0.90 E at ν = 0.3 and 0.91 E at 0.49 for a needle of 0.3 mm in a block of 10 mm.
[[nodiscard]] inline double radius_between_walls(double half_side, double poisson_ratio) {
    const double d = 0.5 - poisson_ratio;
    return half_side * std::exp((2.785 + 5.6 * d * d - 4.0 * d * d * d) / (3.0 - 4.0 * poisson_ratio));
}

/// The force on a rigid round disc of radius r that is bonded into an elastic ring in plane strain, whose rim of radius b is
/// held, for each metre that it moves [Pa].
///
///     k = 8πG(1 − ν) / [(3 − 4ν) ln(b/r) − (b² − r²)/((3 − 4ν)(b² + r²))],     G = E/2(1 + ν)
///
/// Source: Baguelin, Frank and Saïd 1977, Theoretical study of lateral reaction mechanism of piles. Deviation: b counts as 2r at
/// least, so that k stays finite. Valid where a deflection varies slowly along the needle against b: a wave shorter than that is
/// held harder, by what lies above and below.
[[nodiscard]] inline double disc_modulus(const Layer& layer, double radius, double bound) {
    const double r = radius, b = std::max(bound, 2.0 * radius);
    const double shear_modulus = layer.youngs_modulus / (2.0 * (1.0 + layer.poisson_ratio));    // [Pa] G
    const double kappa = 3.0 - 4.0 * layer.poisson_ratio;
    const double flexibility = kappa * std::log(b / r) - (b * b - r * r) / (kappa * (b * b + r * r));
    return 8.0 * std::numbers::pi * shear_modulus * (1.0 - layer.poisson_ratio) / flexibility;
}

}    // namespace stylet
