#include "euler.h"

#include <algorithm>
#include <numbers>

namespace stylet::euler {
namespace {

/// k of P = k·EI/L², dimensionless.
double end_factor(Ends ends) {
    constexpr double pi_squared = std::numbers::pi * std::numbers::pi;
    constexpr double root = 4.493409457909064;    // the first positive one of tan x = x
    switch (ends) {
        case Ends::clamped_free:
            return pi_squared / 4.0;
        case Ends::pinned_pinned:
            return pi_squared;
        case Ends::clamped_pinned:
            return root * root;
        case Ends::clamped_clamped:
            return 4.0 * pi_squared;
    }
    return pi_squared / 4.0;    // the least of them, for a value outside the enumeration
}

}    // namespace

double Euler::critical_load(const Column& column) const {
    const double length = std::max(column.free_length, column.radius);
    return end_factor(column.ends) * column.bending_stiffness / (length * length);
}

}    // namespace stylet::euler

STYLET_PLUGIN(
    stylet::euler::Euler, "euler", stylet::no_parameters, .summary = "The critical load of an ideal straight column in air",
    .formula =
        "P = k EI/L^2\n"
        "k = pi^2/4 clamped-free, pi^2 pinned-pinned, 4.4934^2 clamped-pinned (tan x = x), 4 pi^2 clamped-clamped\n"
        "P [N] critical load, EI [N m^2] bending stiffness, L [m] free length",
    .source =
        "Euler 1757; Timoshenko and Gere 1961, Theory of Elastic Stability, sections 2.1 to 2.3; Eq. (1) of He, Chen and Tang "
        "is the clamped-free one. Deviation: a free length below the needle's radius counts as the radius",
    .validity =
        "Slender columns (L above 20 r) that carry their load along the axis, stay elastic and touch nothing between their "
        "ends. Leaves out shortening, shear, own weight, imperfections and any support from tissue")
