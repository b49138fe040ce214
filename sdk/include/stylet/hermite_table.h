#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace stylet {

/// A function tabulated at equal steps from 0 on, a cubic between each two knots that has their values and slopes (Hermite).
/// Value, slope and integral are those of the same cubics, so they agree to rounding. Off the function itself by at most
/// h⁴/384 of its fourth derivative. Beyond its ends it has the answers at its ends. Allocates when it is made, never later.
class HermiteTable {
public:
    struct Knot {
        double value, slope;
    };

    /// At least two knots, `step` > 0 apart.
    HermiteTable(double step, std::vector<Knot> knots) : step_(step), knots_(std::move(knots)), sums_(knots_.size()) {
        for (std::size_t i = 1; i < knots_.size(); ++i) sums_[i] = sums_[i - 1] + piece_integral(i - 1, 1.0);
    }

    [[nodiscard]] double end() const { return step_ * static_cast<double>(knots_.size() - 1); }

    [[nodiscard]] double value(double x) const {
        const auto [i, t] = find(x);
        const Knot &a = knots_[i], &b = knots_[i + 1];
        const double r = 1.0 - t;
        return (1.0 + 2.0 * t) * r * r * a.value + t * r * r * step_ * a.slope + t * t * (3.0 - 2.0 * t) * b.value -
               t * t * r * step_ * b.slope;
    }

    [[nodiscard]] double slope(double x) const {
        const auto [i, t] = find(x);
        const Knot &a = knots_[i], &b = knots_[i + 1];
        return 6.0 * t * (1.0 - t) * (b.value - a.value) / step_ + (1.0 - t) * (1.0 - 3.0 * t) * a.slope +
               t * (3.0 * t - 2.0) * b.slope;
    }

    /// From 0 to x.
    [[nodiscard]] double integral(double x) const {
        const auto [i, t] = find(x);
        return sums_[i] + piece_integral(i, t);
    }

private:
    struct Place {
        std::size_t piece;
        double t;    // 0 to 1 in it
    };

    [[nodiscard]] Place find(double x) const {
        const double steps = std::clamp(x / step_, 0.0, static_cast<double>(knots_.size() - 1));
        const auto piece = std::min(static_cast<std::size_t>(steps), knots_.size() - 2);
        return {piece, steps - static_cast<double>(piece)};
    }

    [[nodiscard]] double piece_integral(std::size_t i, double t) const {
        const Knot &a = knots_[i], &b = knots_[i + 1];
        const double t2 = t * t, t3 = t2 * t, t4 = t2 * t2;
        return step_ * (a.value * (t - t3 + 0.5 * t4) + step_ * a.slope * (0.5 * t2 - 2.0 / 3.0 * t3 + 0.25 * t4) +
                        b.value * (t3 - 0.5 * t4) + step_ * b.slope * (0.25 * t4 - t3 / 3.0));
    }

    double step_;
    std::vector<Knot> knots_;
    std::vector<double> sums_;    // of the pieces before each knot
};

}    // namespace stylet
