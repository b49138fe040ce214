// For tests: exact shapes of thin rods, by elliptic integrals and by integrating the rod's equation. Rods of unit length and unit
// bending stiffness, so a load is in EI/L² and a place in L.
#pragma once

#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/ellint_2.hpp>
#include <boost/math/special_functions/jacobi_elliptic.hpp>
#include <boost/math/tools/roots.hpp>
#include <boost/numeric/odeint/integrate/integrate_adaptive.hpp>
#include <boost/numeric/odeint/stepper/bulirsch_stoer.hpp>

#include <array>
#include <cmath>
#include <numbers>

namespace stylet::rod {

/// A bowed column.
struct Column {
    double load;    // along the line between its ends
    double span;    // between its ends, along that line
};

struct Bow : Column {
    double deflection;    // of its middle, or of its free end
};

/// Pinned at both ends, `slope` [rad] there: k = sin(α/2), load 4K², deflection k/K, span 2E/K − 1 (Love 1927, section 263).
inline Bow pinned_pinned(double slope) {
    const double k = std::sin(0.5 * slope), K = boost::math::ellint_1(k), E = boost::math::ellint_2(k);
    return {{.load = 4.0 * K * K, .span = 2.0 * E / K - 1.0}, k / K};
}

/// Clamped at one end, free at the other with this slope: half of a pinned-pinned one.
inline Bow clamped_free(double slope) {
    const Bow whole = pinned_pinned(slope);
    return {{.load = 0.25 * whole.load, .span = whole.span}, 2.0 * whole.deflection};
}

/// Where the end of a rod is that is clamped level and pulled down by loads.
struct Hanging {
    double reach, drop;
};

/// φ'' = load(u) sin φ with φ the angle to the vertical and u from the free end, where φ' = 0; φ(1) = π/2. `load` is the force
/// below u. Shoots from the free end for its φ, to 1e-12.
template <class Load>
Hanging hanging(Load load) {
    using State = std::array<double, 4>;    // φ, φ', reach and drop from the free end
    const auto from = [&](double log_angle) {
        State state{std::exp(log_angle), 0.0, 0.0, 0.0};
        const auto slope = [&](const State& s, State& ds, double u) {
            ds = {s[1], load(u) * std::sin(s[0]), std::sin(s[0]), std::cos(s[0])};
        };
        boost::numeric::odeint::bulirsch_stoer<State> stepper(1e-13, 1e-13);
        boost::numeric::odeint::integrate_adaptive(stepper, slope, state, 0.0, 1.0, 1e-3);
        return state;
    };
    const auto over_level = [&](double log_angle) { return from(log_angle)[0] - 0.5 * std::numbers::pi; };
    double first = -40.0;    // the least angle that comes out level: others are of rods that stand up
    while (over_level(first + 1.0) < 0.0) first += 1.0;
    boost::uintmax_t most = 200;
    const auto [low, high] =
        boost::math::tools::toms748_solve(over_level, first, first + 1.0, boost::math::tools::eps_tolerance<double>(50), most);
    const State end = from(0.5 * (low + high));
    return {.reach = end[2], .drop = end[3]};
}

/// A clamped-pinned column by its modulus k < 0.91: the arc of a pendulum's swing from u₀ = 3K − λ to a bend of none at 3K, with
/// λ such that the pin is on the clamp's axis. The first bow starts at the critical load, λ = 4.4934 (tan λ = λ).
inline Column clamped_pinned(double k) {
    const double K = boost::math::ellint_1(k);
    struct End {
        double along, across, angle;
    };
    const auto end_of = [&](double length) {    // in the frame of the end force
        const double u0 = 3.0 * K - length, u1 = 3.0 * K;
        double cn0, dn0, cn1, dn1;
        const double sn0 = boost::math::jacobi_elliptic(k, u0, &cn0, &dn0);
        boost::math::jacobi_elliptic(k, u1, &cn1, &dn1);
        const auto amplitude = [&](double u) {    // am u, between its quarter periods
            const double turns = std::round(u / (2.0 * K));
            double cn, dn;
            const double sn = boost::math::jacobi_elliptic(k, u - 2.0 * K * turns, &cn, &dn);
            return std::numbers::pi * turns + std::atan2(sn, cn);
        };
        const double arc = boost::math::ellint_2(k, amplitude(u1)) - boost::math::ellint_2(k, amplitude(u0));
        return End{(2.0 * arc - length) / length, -2.0 * k * (cn1 - cn0) / length, 2.0 * std::asin(k * sn0)};
    };
    boost::uintmax_t most = 200;
    const auto off = [&](double length) {
        const End end = end_of(length);
        return end.across * std::cos(end.angle) - end.along * std::sin(end.angle);
    };
    const auto [low, high] =
        boost::math::tools::toms748_solve(off, 2.2 * K, 2.98 * K, boost::math::tools::eps_tolerance<double>(48), most);
    const double length = 0.5 * (low + high);
    const End end = end_of(length);
    const double span = std::hypot(end.along, end.across);
    return {.load = length * length * std::cos(end.angle), .span = span};
}

}    // namespace stylet::rod
