#pragma once

namespace stylet::study {

/// Mean displacement, along the force, of a rectangle with sides a and b [m] on an elastic half-space that carries a force F
/// [N] normal to the surface, shared evenly:
///
///     w = (1 − ν²) F I/(π E a² b²),   I = 2ab(a asinh(b/a) + b asinh(a/b)) − ⅔(c³ − a³ − b³),   c² = a² + b²
///
/// I [m³] is 1/r integrated over both ends of r in the rectangle; of a square w = 0.9464 (1 − ν²) F/(E a).
/// Source: Love 1929 (Phil. Trans. R. Soc. A 228); Timoshenko and Goodier 1970, article 139, has the means. Leaves out the
/// bottom and the sides of a block.
[[nodiscard]] double mean_displacement(double a, double b, double force, double youngs_modulus, double poisson_ratio);    // [m]

}    // namespace stylet::study
