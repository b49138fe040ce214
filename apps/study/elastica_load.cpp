#include "apps/study/elastica_load.h"

#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/ellint_2.hpp>
#include <boost/math/tools/roots.hpp>

#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>

namespace stylet::study {
namespace {

using boost::math::ellint_1;
using boost::math::ellint_2;
using std::numbers::pi;

constexpr double clamped_pinned_root = 4.493409457909064;    // tan q = q

/// Where `function` changes sign between two ends that it has different signs at, to rounding.
template <class Function>
double root(const Function& function, double low, double high) {
    constexpr int bits = std::numeric_limits<double>::digits - 2;
    std::uintmax_t most_steps = 100;
    const auto [left, right] =
        boost::math::tools::toms748_solve(function, low, high, boost::math::tools::eps_tolerance<double>(bits), most_steps);
    return 0.5 * (left + right);
}

/// A column's shape: how near its ends have come, and its load.
struct Shape {
    double shortening;    // d
    double load;          // P/P_cr
};

/// Of quarter waves whose ends' slopes differ by α = 2 asin(k).
Shape quarter_waves(double k) {
    const double complete = ellint_1(k);
    return {2.0 - 2.0 * ellint_2(k) / complete, std::pow(2.0 * complete / pi, 2)};
}

/// Clamped-pinned; see the header for the letters.
struct LeaningThrust {
    double k, phi;
    double beta, arc, along, across;

    LeaningThrust(double modulus, double phi_0)
        : k(modulus),
          phi(phi_0),
          beta(2.0 * std::asin(k * std::sin(phi))),
          arc(3.0 * ellint_1(k) - ellint_1(k, phi)),
          along(2.0 * (3.0 * ellint_2(k) - ellint_2(k, phi)) - arc),
          across(2.0 * k * std::cos(phi)) {}

    [[nodiscard]] double off_axis() const { return across * std::cos(beta) - along * std::sin(beta); }
    [[nodiscard]] Shape shape() const {
        return {1.0 - (along * std::cos(beta) + across * std::sin(beta)) / arc,
                std::pow(arc / clamped_pinned_root, 2) * std::cos(beta)};
    }
};

Shape clamped_pinned(double k) {
    const double phi = root([k](double angle) { return LeaningThrust(k, angle).off_axis(); }, 0.0, pi / 2.0);
    return LeaningThrust(k, phi).shape();
}

}    // namespace

double elastica_load(Ends ends, double d) {
    constexpr double lost = 1e-12;                              // d that rounding swallows; the load is 1 + d/2 there, or less
    constexpr double straight = 1e-9, folded = 0.9089085575;    // k at d = 1e-18 and 1, where K = 2E and the ends meet
    if (!(d > 0.0 && d <= furthest_shortening)) return std::numeric_limits<double>::quiet_NaN();
    if (d < lost) return 1.0;
    const auto shape = ends == Ends::clamped_pinned ? clamped_pinned : quarter_waves;
    return shape(root([&](double k) { return shape(k).shortening - d; }, straight, folded)).load;
}

double euler_factor(Ends ends) {
    switch (ends) {
        case Ends::clamped_free:
            return pi * pi / 4.0;
        case Ends::pinned_pinned:
            return pi * pi;
        case Ends::clamped_pinned:
            return clamped_pinned_root * clamped_pinned_root;
        case Ends::clamped_clamped:
            return 4.0 * pi * pi;
    }
    return std::numeric_limits<double>::quiet_NaN();
}

}    // namespace stylet::study
