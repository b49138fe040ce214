// For the tests: arcs by their modulus, each solved for by bracketing rather than as the tables are.
#pragma once

#include "arc.h"

#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/tools/roots.hpp>

#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace stylet::elastica {

inline constexpr std::array all_ends{Ends::clamped_free, Ends::pinned_pinned, Ends::clamped_pinned, Ends::clamped_clamped};
inline constexpr std::array names{"clamped-free", "pinned-pinned", "clamped-pinned", "clamped-clamped"};

/// Of the largest angle to the end force α [degrees], up to 130.
inline Arc bowed(Ends ends, double degrees) {
    const double k = std::sin(degrees * std::numbers::pi / 360.0), K = boost::math::ellint_1(k);
    const auto misfit = [ends, k](double length) { return Arc(ends, k, length).misfit(); };
    if (ends == Ends::clamped_free) return {ends, k, K};
    if (ends == Ends::pinned_pinned) return {ends, k, 2.0 * K};
    if (ends == Ends::clamped_clamped) return {ends, k, 4.0 * K};
    std::uintmax_t iterations = 100;
    const auto [low, high] =
        boost::math::tools::toms748_solve(misfit, 1.8 * K, 2.87 * K, boost::math::tools::eps_tolerance<double>(52), iterations);
    return {ends, k, 0.5 * (low + high)};
}

}    // namespace stylet::elastica
