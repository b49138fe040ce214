// The exact arcs against published figures, against each other, and against the elastica's equation integrated by itself.
#include "bowed_arc.h"

#include <Eigen/Dense>

#include <gtest/gtest.h>

#include <cstdio>

namespace stylet::elastica {
namespace {

using std::numbers::pi;
constexpr double rounding = 1e-12;    // of elliptic functions, a few hundred roundings

TEST(Arc, HasThePublishedPinnedPinnedColumns) {
    // Timoshenko and Gere 1961, table 2-4, to five digits: end slope, P/P_cr, deflection at the middle and span over the length.
    constexpr double printed = 5e-6;
    const double rows[][4] = {{10.0, 1.00382, 0.05538, 0.99240}, {20.0, 1.01540, 0.10971, 0.96973},
                              {40.0, 1.06366, 0.21112, 0.88120}, {60.0, 1.15172, 0.29660, 0.74102},
                              {90.0, 1.39320, 0.38138, 0.45695}, {120.0, 1.88480, 0.40159, 0.12316}};
    for (const auto& [slope, load, middle, span] : rows) {
        const Arc arc = bowed(Ends::pinned_pinned, slope);
        EXPECT_NEAR(arc.load() / (pi * pi), load, printed) << slope;
        EXPECT_NEAR(arc.at(0.5).aside, middle, printed) << slope;
        EXPECT_NEAR(arc.deflection(), middle, printed) << slope;
        EXPECT_NEAR(arc.at(1.0).along, span, printed) << slope;
        EXPECT_NEAR(arc.largest_slope() * 180.0 / pi, slope, rounding * 180.0);
    }
}

TEST(Arc, OfOtherEndsIsMadeOfPiecesOfThePinnedPinnedOne) {
    for (const double degrees : {1.0, 30.0, 75.0, 110.0, 130.0}) {
        const Arc whole = bowed(Ends::pinned_pinned, degrees), half = bowed(Ends::clamped_free, degrees);
        const Arc twice = bowed(Ends::clamped_clamped, degrees);
        EXPECT_NEAR(half.load(), whole.load() / 4.0, rounding * whole.load());
        EXPECT_NEAR(twice.load(), whole.load() * 4.0, 4.0 * rounding * whole.load());
        const BowPoint middle = whole.at(0.5);
        for (const double s : {0.2, 0.5, 0.9, 1.0}) {
            // From the middle of a pinned-pinned column of twice the length, seen from the tangent there.
            const BowPoint place = whole.at(0.5 - 0.5 * s), point = half.at(s);
            EXPECT_NEAR(point.along, 2.0 * (middle.along - place.along), rounding);
            EXPECT_NEAR(point.aside, 2.0 * (middle.aside - place.aside), rounding);
            // Its first quarter is half a clamped-free column turned about the inflection.
            const BowPoint quarter = twice.at(0.25 * s);
            EXPECT_NEAR(quarter.along, 0.25 * point.along, rounding);
            EXPECT_NEAR(quarter.aside, 0.25 * point.aside, rounding);
        }
        EXPECT_NEAR(half.deflection(), 2.0 * whole.deflection(), rounding);
    }
}

TEST(Arc, HoldsItsEndsAsDeclared) {
    for (const Ends ends : all_ends) {
        for (const double degrees : {0.1, 20.0, 60.0, 100.0, 130.0}) {
            const Arc arc = bowed(ends, degrees);
            constexpr double h = 1e-6, differences = 1e-4;    // h times a curvature that changes by less than λ² ≤ 90
            const double bend_first = (arc.at(h).tangent - arc.at(0.0).tangent) / h;
            const double bend_last = (arc.at(1.0).tangent - arc.at(1.0 - h).tangent) / h;
            EXPECT_NEAR(arc.at(0.0).along, 0.0, rounding);
            EXPECT_NEAR(arc.at(0.0).aside, 0.0, rounding);
            if (ends != Ends::clamped_free) {
                EXPECT_NEAR(arc.at(1.0).aside, 0.0, rounding);
            }
            if (ends != Ends::pinned_pinned) {
                EXPECT_NEAR(arc.at(0.0).tangent, 0.0, rounding);
            }
            if (ends == Ends::pinned_pinned) {
                EXPECT_NEAR(bend_first, 0.0, differences);
            }
            if (ends == Ends::clamped_clamped) {
                EXPECT_NEAR(arc.at(1.0).tangent, 0.0, rounding);
            }
            if (ends != Ends::clamped_clamped) {
                EXPECT_NEAR(bend_last, 0.0, differences);
            }
        }
    }
}

/// The elastica's own equation, θ' = κ, κ' = −N sin θ + R cos θ, x' = cos θ, y' = sin θ, by Runge and Kutta from the base.
struct Shot {
    Eigen::Vector4d end;    // θ, κ, x, y
    double deflection = 0.0, energy = 0.0;
};

Shot shoot(double load, double reaction, double slope, double bend) {
    constexpr int steps = 4000;
    constexpr double h = 1.0 / steps;
    const auto rate = [&](const Eigen::Vector4d& at) -> Eigen::Vector4d {
        return {at[1], -load * std::sin(at[0]) + reaction * std::cos(at[0]), std::cos(at[0]), std::sin(at[0])};
    };
    Shot shot{.end = {slope, bend, 0.0, 0.0}};
    for (int i = 0; i < steps; ++i) {
        const Eigen::Vector4d a = rate(shot.end), b = rate(shot.end + 0.5 * h * a), c = rate(shot.end + 0.5 * h * b);
        const Eigen::Vector4d middle = shot.end + 0.5 * h * b;
        const double before = shot.end[1];
        shot.end += h / 6.0 * (a + 2.0 * b + 2.0 * c + rate(shot.end + h * c));
        shot.energy += h / 12.0 * (before * before + 4.0 * middle[1] * middle[1] + shot.end[1] * shot.end[1]);
        shot.deflection = std::max(shot.deflection, std::abs(shot.end[3]));
    }
    return shot;
}

/// The column that the equation and its ends alone make of a load: Newton on what is unknown at the base, from a guess 2 % off.
Shot column(Ends ends, const Arc& near) {
    const bool pinned = ends == Ends::pinned_pinned;
    constexpr double h = 1e-6;
    const double bend = (near.at(h).tangent - near.at(0.0).tangent) / h;
    Eigen::Vector2d unknown(1.02 * (pinned ? near.at(0.0).tangent : bend),
                            ends == Ends::clamped_pinned ? -0.98 * bend / near.at(1.0).along : 0.0);
    const auto fire = [&](const Eigen::Vector2d& at) {
        return shoot(near.load(), at[1], pinned ? at[0] : 0.0, pinned ? 0.0 : at[0]);
    };
    const auto miss = [&](const Eigen::Vector2d& at) -> Eigen::Vector2d {
        const Eigen::Vector4d end = fire(at).end;
        return {ends == Ends::clamped_clamped ? end[0] : end[1], ends == Ends::clamped_pinned ? end[3] : at[1]};
    };
    for (int newton = 0; newton < 12; ++newton) {
        Eigen::Matrix2d change;
        for (int i = 0; i < 2; ++i) {
            const Eigen::Vector2d nudge = h * Eigen::Vector2d::Unit(i);
            change.col(i) = (miss(unknown + nudge) - miss(unknown - nudge)) / (2.0 * h);
        }
        unknown -= change.inverse() * miss(unknown);
    }
    EXPECT_LE(miss(unknown).norm(), 1e-9) << "the shot did not come in";
    return fire(unknown);
}

TEST(Arc, SolvesTheElasticasEquationByItself) {
    constexpr double integration = 1e-11;    // Runge and Kutta's h⁴ times the fifth power of λ ≤ 9, over 120
    constexpr double sampling = 2e-5;        // of the largest of 4000 samples, and Simpson's of the energy with half steps
    for (std::size_t i = 0; i < all_ends.size(); ++i) {
        for (const double degrees : {20.0, 50.0, 75.0, 100.0, 118.0}) {
            const Arc arc = bowed(all_ends[i], degrees);
            const Shot shot = column(all_ends[i], arc);
            std::printf("%-15s α %5.1f°  N %8.4f EI/L²  shortening %.9f, by the equation %+.1e off\n", names[i], degrees,
                        arc.load(), arc.shortening(), 1.0 - shot.end[2] - arc.shortening());
            EXPECT_NEAR(shot.end[2], 1.0 - arc.shortening(), integration);
            EXPECT_NEAR(shot.deflection, arc.deflection(), sampling);
            EXPECT_NEAR(shot.energy / arc.energy(), 1.0, sampling);
        }
    }
}

}    // namespace
}    // namespace stylet::elastica
