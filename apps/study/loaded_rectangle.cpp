#include "apps/study/loaded_rectangle.h"

#include <cmath>
#include <numbers>

namespace stylet::study {

double mean_displacement(double a, double b, double force, double youngs_modulus, double poisson_ratio) {
    const double c = std::hypot(a, b);
    const double I = 2.0 * a * b * (a * std::asinh(b / a) + b * std::asinh(a / b)) -
                     2.0 / 3.0 * (std::pow(c, 3) - std::pow(a, 3) - std::pow(b, 3));
    return (1.0 - poisson_ratio * poisson_ratio) * force * I / (std::numbers::pi * youngs_modulus * a * a * b * b);
}

}    // namespace stylet::study
