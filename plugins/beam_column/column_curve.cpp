#include "column_curve.h"

#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/ellint_2.hpp>
#include <boost/math/tools/roots.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace stylet::beam_column {

namespace {

using boost::math::ellint_1;
using boost::math::ellint_2;
using std::numbers::pi;

constexpr int pieces = 1000;                            // cubic pieces: the table is within 1e-9 of the formula (its test)
constexpr double folded_slope = 1e3;                    // df/dη of a column folded flat, which can hardly get shorter
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

// Cubic Hermite on [0, h]: values y0, y1 and slopes m0, m1.
struct Cubic {
    double y0, m0, y1, m1, h;

    double value(double x) const {
        const double t = x / h, r = 1.0 - t;
        return (1.0 + 2.0 * t) * r * r * y0 + t * r * r * h * m0 + t * t * (3.0 - 2.0 * t) * y1 - t * t * r * h * m1;
    }
    double slope(double x) const {
        const double t = x / h;
        return 6.0 * t * (1.0 - t) * (y1 - y0) / h + (1.0 - t) * (1.0 - 3.0 * t) * m0 + t * (3.0 * t - 2.0) * m1;
    }
    double integral(double x) const {
        const double t = x / h, t2 = t * t, t3 = t2 * t, t4 = t2 * t2;
        return h * (y0 * (t - t3 + 0.5 * t4) + h * m0 * (0.5 * t2 - 2.0 / 3.0 * t3 + 0.25 * t4) + y1 * (t3 - 0.5 * t4) +
                    h * m1 * (0.25 * t4 - t3 / 3.0));
    }
};

}    // namespace

ColumnCurve::ColumnCurve() : step_(shortening(last_end_slope) / pieces) {
    // The limits at η = 0 by series: η ≈ α²/4, f ≈ 1 + α²/8.
    knots_.push_back({.load = 1.0, .load_slope = 0.5, .square = 0.0, .square_slope = 4.0, .energy = 0.0});
    for (int i = 1; i <= pieces; ++i) {
        const double a = i == pieces ? last_end_slope : end_slope_of(i * step_);
        const double stretch = shortening_slope(a);
        Knot knot{.load = load(a),
                  .load_slope = load_slope(a) / stretch,
                  .square = a * a,
                  .square_slope = 2.0 * a / stretch,
                  .energy = 0.0};
        const Knot& before = knots_.back();
        knot.energy = before.energy + Cubic{before.load, before.load_slope, knot.load, knot.load_slope, step_}.integral(step_);
        knots_.push_back(knot);
    }
}

CurvePoint ColumnCurve::at(double shortening) const {
    const Knot& last = knots_.back();
    if (const double over = shortening - pieces * step_; over >= 0.0) {
        return {last.load + folded_slope * over, folded_slope, last.energy + (last.load + 0.5 * folded_slope * over) * over};
    }
    const int piece = std::clamp(static_cast<int>(shortening / step_), 0, pieces - 1);
    const Knot &a = knots_[piece], &b = knots_[piece + 1];
    const Cubic cubic{a.load, a.load_slope, b.load, b.load_slope, step_};
    const double x = std::max(0.0, shortening - piece * step_);
    return {cubic.value(x), cubic.slope(x), a.energy + cubic.integral(x)};
}

double ColumnCurve::end_slope(double shortening) const {
    if (shortening >= pieces * step_) return last_end_slope;
    const int piece = std::clamp(static_cast<int>(shortening / step_), 0, pieces - 1);
    const Knot &a = knots_[piece], &b = knots_[piece + 1];
    const Cubic cubic{a.square, a.square_slope, b.square, b.square_slope, step_};
    return std::sqrt(std::max(0.0, cubic.value(std::max(0.0, shortening - piece * step_))));
}

double ColumnCurve::amplitude(double end_slope) {
    const double k = std::sin(end_slope);
    return k / (2.0 * ellint_2(k));
}

}    // namespace stylet::beam_column
