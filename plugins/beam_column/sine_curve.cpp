#include "sine_curve.h"

#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/ellint_2.hpp>
#include <boost/math/tools/roots.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace stylet::beam_column {

namespace {

using boost::math::ellint_1;
using boost::math::ellint_2;
using std::numbers::pi;

constexpr int pieces = 1000;                            // cubic pieces: the table is within 1e-9 of the formula (its test)
constexpr double last_end_slope = 89.0 * pi / 180.0;    // [rad]

double shortening(double a) {
    return 1.0 - pi * std::cos(a) / (2.0 * ellint_2(std::sin(a)));
}

double shortening_slope(double a) {    // dη/dα, with dE/dk = (E − K)/k
    const double k = std::sin(a), E = ellint_2(k), K = ellint_1(k);
    return 0.5 * pi * (k / E + std::cos(a) * std::cos(a) * (E - K) / (k * E * E));
}

double load(double a) {
    return std::pow(2.0 * ellint_1(std::sin(0.5 * a)) / pi, 2);
}

double load_slope(double a) {    // df/dα, with dK/dk = (E/(1 − k²) − K)/k
    const double k = std::sin(0.5 * a), K = ellint_1(k), E = ellint_2(k);
    const double dK = (E / (1.0 - k * k) - K) / k;
    return 8.0 / (pi * pi) * K * dK * 0.5 * std::cos(0.5 * a);
}

double end_slope_of(double eta) {
    std::uintmax_t iterations = 100;
    const auto [low, high] = boost::math::tools::toms748_solve([eta](double a) { return shortening(a) - eta; }, 0.0, 0.5 * pi,
                                                               boost::math::tools::eps_tolerance<double>(52), iterations);
    return 0.5 * (low + high);
}

// Knots at equal steps of η; `of` makes one of an end slope, `first` is its limit at η = 0, by series: η ≈ α²/4, f ≈ 1 + α²/8.
template <class Function>
HermiteTable tabulate(HermiteTable::Knot first, Function of) {
    const double step = shortening(last_end_slope) / pieces;
    std::vector<HermiteTable::Knot> knots{first};
    for (int i = 1; i <= pieces; ++i) knots.push_back(of(i == pieces ? last_end_slope : end_slope_of(i * step)));
    return {step, std::move(knots)};
}

HermiteTable::Knot load_knot(double a) {
    return {.value = load(a), .slope = load_slope(a) / shortening_slope(a)};
}

HermiteTable::Knot square_knot(double a) {
    return {.value = a * a, .slope = 2.0 * a / shortening_slope(a)};
}

// Where along the span (0 to 1) a half sine with end slope `a` has the fraction `arc` of its length behind it: E(πx, k) =
// 2E(k)·arc.
double abscissa(double arc, double a) {
    const double k = std::sin(a), target = 2.0 * ellint_2(k) * arc;
    double phase = pi * arc;
    for (int newton = 0; newton < 20; ++newton) {    // for drawing; converges in 3–5 below 60°
        const double rate = std::sqrt(1.0 - k * k * std::pow(std::sin(phase), 2));
        phase = std::clamp(phase - (ellint_2(k, phase) - target) / rate, 0.0, pi);
    }
    return phase / pi;
}

}    // namespace

SineCurve::SineCurve()
    : ColumnCurve(tabulate({.value = 1.0, .slope = 0.5}, load_knot)),
      square_(tabulate({.value = 0.0, .slope = 4.0}, square_knot)) {}

double SineCurve::own_factor() const {
    return std::numeric_limits<double>::infinity();
}

double SineCurve::largest_slope(double shortening) const {
    return std::sqrt(std::max(0.0, square_.value(shortening)));
}

double SineCurve::amplitude(double end_slope) {
    const double k = std::sin(end_slope);
    return k / (2.0 * ellint_2(k));
}

BowPoint SineCurve::bow(double shortening, double arc) const {
    const double slope = largest_slope(shortening);
    const double x = abscissa(arc, slope);
    return {.along = x * (1.0 - shortening),
            .aside = amplitude(slope) * std::sin(pi * x),
            .tangent = std::atan(std::tan(slope) * std::cos(pi * x))};
}

}    // namespace stylet::beam_column
