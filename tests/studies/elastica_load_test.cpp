// The load of a buckled column, against printed figures and against its differential equation.
#include "apps/study/elastica_load.h"

#include <gtest/gtest.h>
#include <Eigen/Dense>

#include <cmath>
#include <cstdio>

namespace stylet::study {
namespace {

TEST(ElasticaLoad, OfPinnedEndsIsThePrintedTable) {
    struct Row {
        double span;    // of the length
        double load;    // of the critical one
    };
    // At end slopes of 10, 20, 40, 60, 90 and 120 degrees.
    constexpr Row table[] = {{.99240, 1.00382}, {.96973, 1.01540}, {.88120, 1.06366},
                             {.74102, 1.15172}, {.45695, 1.39320}, {.12316, 1.88480}};
    constexpr double digits = 0.5e-5;
    for (const Row& row : table) {
        const double load = elastica_load(Ends::pinned_pinned, 1.0 - row.span);
        const double steeper = elastica_load(Ends::pinned_pinned, 1.0 - row.span + digits);
        std::printf("span %.5f: P/Pcr %.6f, printed %.5f\n", row.span, load, row.load);
        EXPECT_NEAR(load, row.load, digits + (steeper - load)) << "both printed numbers are rounded";
    }
}

TEST(ElasticaLoad, IsOneCurveForAllQuarterWaves) {
    for (const double d : {0.01, 0.3, 0.9}) {
        EXPECT_EQ(elastica_load(Ends::clamped_clamped, d), elastica_load(Ends::pinned_pinned, d));
        EXPECT_EQ(elastica_load(Ends::clamped_free, d), elastica_load(Ends::pinned_pinned, d));
    }
}

TEST(ElasticaLoad, OfAClampAndAPinIsGreatestWhereItsLimitIsKnown) {
    double most = 0.0, where = 0.0;
    for (double d = 0.40; d < 0.50; d += 1e-4) {
        const double load = elastica_load(Ends::clamped_pinned, d);
        if (load > most) most = load, where = d;
    }
    std::printf("clamped-pinned limit: P/Pcr %.6f at d = %.4f L; known 1.1396 at 0.454\n", most, where);
    EXPECT_NEAR(most, 1.1396, 0.5e-4);
    EXPECT_NEAR(where, 0.454, 0.5e-3);
}

/// Clamped at s = 0, on the axis and without moment at s = 1, under a thrust that leans by beta against the axis; EI = L = 1.
class LeaningColumn {
public:
    explicit LeaningColumn(double beta) : beta_(beta) {}

    struct End {
        double x, y, curvature;
    };

    /// Runge and Kutta's fourth order along θ'' = −F sin(θ + β).
    [[nodiscard]] End end(double thrust, double curvature) const {
        constexpr int steps = 2000;
        constexpr double h = 1.0 / steps;
        const auto slope = [&](const Eigen::Vector4d& s) -> Eigen::Vector4d {    // of x, y, θ, θ'
            return {std::cos(s[2]), std::sin(s[2]), s[3], -thrust * std::sin(s[2] + beta_)};
        };
        Eigen::Vector4d state(0.0, 0.0, 0.0, curvature);
        for (int i = 0; i < steps; ++i) {
            const Eigen::Vector4d a = slope(state), b = slope(state + 0.5 * h * a), c = slope(state + 0.5 * h * b),
                                  d = slope(state + h * c);
            state += h / 6.0 * (a + 2.0 * b + 2.0 * c + d);
        }
        return {state[0], state[1], state[3]};
    }

    /// Newton on both conditions at the pin, from a guess; leaves the thrust and the curvature at the clamp in it.
    void solve(Eigen::Vector2d& guess) const {
        const auto miss = [&](const Eigen::Vector2d& at) {
            const End pin = end(at[0], at[1]);
            return Eigen::Vector2d(pin.y, pin.curvature);
        };
        constexpr double step = 1e-6;
        for (int i = 0; i < 20; ++i) {
            const Eigen::Vector2d missed = miss(guess);
            Eigen::Matrix2d tangent;
            tangent << (miss(guess + Eigen::Vector2d(step, 0.0)) - missed) / step,
                (miss(guess + Eigen::Vector2d(0.0, step)) - missed) / step;
            guess -= tangent.fullPivLu().solve(missed);
        }
    }

private:
    double beta_;
};

TEST(ElasticaLoad, OfAClampAndAPinSolvesTheColumnsDifferentialEquation) {
    const double critical = euler_factor(Ends::clamped_pinned);
    constexpr double close = 1e-8;                          // Newton by differences; Runge and Kutta at 2000 steps is nearer
    Eigen::Vector2d solution(critical, 0.05 * critical);    // of the straight column's mode
    for (double beta = 0.05; beta < 1.8; beta += 0.05) {    // past a right angle the hand pulls
        const LeaningColumn column(beta);
        column.solve(solution);
        const double d = 1.0 - column.end(solution[0], solution[1]).x;
        const double load = solution[0] * std::cos(beta) / critical;
        if (std::abs(std::remainder(beta, 0.25)) < 0.01) {
            std::printf("lean %.2f: d = %.8f L, P/Pcr %.8f by the equation, %.8f by elliptic integrals\n", beta, d, load,
                        elastica_load(Ends::clamped_pinned, d));
        }
        EXPECT_NEAR(elastica_load(Ends::clamped_pinned, d), load, close);
    }
}

TEST(ElasticaLoad, TendsToTheCriticalLoadAndIsNoneBeyondItsRange) {
    for (const Ends ends : {Ends::clamped_free, Ends::pinned_pinned, Ends::clamped_pinned, Ends::clamped_clamped}) {
        double last = 1.0;
        for (double d = 1e-16; d < 0.3; d *= 3.0) {
            const double load = elastica_load(ends, d);
            EXPECT_GE(load, last) << d;
            EXPECT_LT(load, 1.0 + 0.7 * d + 1e-15) << d;
            last = load;
        }
        EXPECT_TRUE(std::isfinite(elastica_load(ends, furthest_shortening)));
        for (const double beyond : {-1.0, 0.0, 0.991, 1.0, 3.0, std::nan("")}) {
            EXPECT_TRUE(std::isnan(elastica_load(ends, beyond))) << beyond;
        }
    }
}

TEST(EulerFactor, IsThePrintedOne) {
    EXPECT_NEAR(euler_factor(Ends::clamped_free), 2.4674, 0.5e-4);
    EXPECT_NEAR(euler_factor(Ends::pinned_pinned), 9.8696, 0.5e-4);
    EXPECT_NEAR(euler_factor(Ends::clamped_pinned), 20.1907, 0.5e-4);
    EXPECT_NEAR(euler_factor(Ends::clamped_clamped), 39.4784, 0.5e-4);
}

}    // namespace
}    // namespace stylet::study
