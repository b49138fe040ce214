// The tables against the formulas, and the curve against what is known of it.
#include "elastica_curve.h"
#include "bowed_arc.h"

#include <boost/math/quadrature/gauss_kronrod.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <vector>

namespace stylet::elastica {
namespace {

using std::numbers::pi;
constexpr double table =
    1e-9;    // a thousand cubic pieces: h⁴/384 of the fourth derivative, largest where the load falls fastest

template <class Function>
void for_each_arc(Function check) {
    for (std::size_t i = 0; i < all_ends.size(); ++i) {
        SCOPED_TRACE(names[i]);
        const ElasticaCurve& curve = ElasticaCurve::of(all_ends[i]);
        for (double degrees = 0.05; degrees < 130.0; degrees += 0.37) {
            const Arc arc = bowed(all_ends[i], degrees);
            if (arc.shortening() < curve.folded()) check(curve, arc);
        }
    }
}

TEST(ElasticaCurve, IsTheFormulas) {
    double load = 0.0, shape = 0.0, deflection = 0.0, slope = 0.0;
    for_each_arc([&](const ElasticaCurve& curve, const Arc& arc) {
        const double eta = arc.shortening();
        load = std::max(load, std::abs(curve.at(eta).load - arc.load() / curve.own_factor()));
        deflection = std::max(deflection, std::abs(curve.deflection(eta) - arc.deflection()));
        slope = std::max(slope, std::abs(curve.largest_slope(eta) - arc.largest_slope()));
        for (const double s : {0.1, 0.37, 0.8, 1.0}) {
            shape = std::max({shape, std::abs(curve.bow(eta, s).along - arc.at(s).along),
                              std::abs(curve.bow(eta, s).aside - arc.at(s).aside)});
        }
    });
    std::printf("tables against the formulas: load %.1e, shape %.1e, deflection %.1e, slope %.1e at worst\n", load, shape,
                deflection, slope);
    EXPECT_LE(load, table);
    EXPECT_LE(shape, table);
    EXPECT_LE(deflection, table);
    EXPECT_LE(slope, table);
}

TEST(ElasticaCurve, StoresTheBendingEnergyOfItsShape) {
    double worst = 0.0;
    for_each_arc([&](const ElasticaCurve& curve, const Arc& arc) {
        const double stored = curve.own_factor() * curve.at(arc.shortening()).energy;
        worst = std::max(worst, std::abs(stored - arc.energy()) / std::max(1.0, arc.energy()));
    });
    std::printf("the work of the load against the bending energy of the shape: %.1e off at worst\n", worst);
    EXPECT_LE(worst, table);
}

TEST(ElasticaCurve, SlopeAndEnergyAreTheLoads) {
    for (const Ends ends : all_ends) {
        const ElasticaCurve& curve = ElasticaCurve::of(ends);
        for (const double eta : {1e-4, 0.01, 0.1, 0.3, 0.5, 0.7, 0.8}) {
            constexpr double h = 1e-7, differences = 2e-6;    // 1e-16/h of rounding, and a piece's second derivative times h
            EXPECT_NEAR((curve.at(eta + h).load - curve.at(eta - h).load) / (2.0 * h), curve.at(eta).slope, differences);
            EXPECT_NEAR((curve.at(eta + h).energy - curve.at(eta - h).energy) / (2.0 * h), curve.at(eta).load, differences);
        }
        EXPECT_EQ(curve.at(0.0).load, 1.0);
        EXPECT_EQ(curve.at(0.0).energy, 0.0);
    }
}

/// The post-buckling slope df/dη at η = 0 by Koiter's expansion in the amplitude a of the linear mode θ₁:
/// θ = aθ₁ + a³θ₃, N = P(1 + na²), R = aR₁ + …, and n P∫θ₁² = P/6 ∫θ₁⁴ − 2/3 R₁∫θ₁³ from the equation of θ₃ being solvable,
/// η = a²/2 ∫θ₁².
double koiter(double straight, double reaction, double (*mode)(double, double)) {
    const auto moment = [&](int power) {
        const auto integrand = [&](double s) { return std::pow(mode(straight, s), power); };
        return boost::math::quadrature::gauss_kronrod<double, 61>::integrate(integrand, 0.0, 1.0, 5, 1e-13);
    };
    const double load = straight * straight;
    const double n = (load / 6.0 * moment(4) - 2.0 / 3.0 * reaction * moment(3)) / (load * moment(2));
    return 2.0 * n / moment(2);
}

TEST(ElasticaCurve, BeginsWithKoitersSlope) {
    constexpr double extrapolated = 1e-6;    // from slopes at a shortening of 1e-4 and 2e-4
    const auto pinned = [](double q, double s) { return std::cos(q * s); };
    const auto clamped = [](double q, double s) { return std::sin(q * s); };
    // θ₁ = 1 − cos qs + b sin qs with R₁ = q²; no bending at the pin: tan q + b = 0, so b = −q.
    const auto clamped_pinned = [](double q, double s) { return 1.0 - std::cos(q * s) - q * std::sin(q * s); };
    const double root = std::sqrt(ElasticaCurve::of(Ends::clamped_pinned).own_factor());
    const double expected[] = {koiter(0.5 * pi, 0.0, clamped), koiter(pi, 0.0, pinned), koiter(root, root * root, clamped_pinned),
                               koiter(2.0 * pi, 0.0, clamped)};
    for (std::size_t i = 0; i < all_ends.size(); ++i) {
        const double slope = ElasticaCurve::of(all_ends[i]).at(0.0).slope;
        std::printf("%-15s d(N/P_cr)/d(shortening/L) %.6f at first, by Koiter %.6f\n", names[i], slope, expected[i]);
        EXPECT_NEAR(slope, expected[i], extrapolated);
    }
}

TEST(ElasticaCurve, ReachesTheClampedPinnedLimitLoadAndFallsToNextToNothing) {
    const ElasticaCurve& curve = ElasticaCurve::of(Ends::clamped_pinned);
    double limit = 0.0, where = 0.0;
    for (double eta = 0.0; eta < curve.folded(); eta += 1e-4) {
        if (curve.at(eta).load <= limit) continue;
        limit = curve.at(eta).load;
        where = eta;
    }
    std::printf("clamped-pinned: limit load %.4f P_cr at a shortening of %.4f L and a slope of %.1f° at the pin\n", limit, where,
                curve.largest_slope(where) * 180.0 / pi);
    EXPECT_NEAR(limit, 1.14, 0.0114);    // validation: 1.14 ± 1 %
    EXPECT_NEAR(limit, 1.1396, 5e-5);    // as declared
    EXPECT_NEAR(where, 0.454, 5e-4);
    double before = limit;
    for (double eta = where + 1e-3; eta < curve.folded(); eta += 1e-3) {
        EXPECT_LT(curve.at(eta).load, before) << eta;
        EXPECT_LT(curve.at(eta).slope, 0.0) << eta;
        before = curve.at(eta).load;
    }
    const double last = curve.at(curve.folded()).load;
    std::printf("clamped-pinned: carries %.4f P_cr at a shortening of %.4f L\n", last, curve.folded());
    EXPECT_GT(last, 0.0);
    EXPECT_LT(last, 2e-3);
}

TEST(ElasticaCurve, OfOtherEndsNeverFalls) {
    for (const Ends ends : {Ends::clamped_free, Ends::pinned_pinned, Ends::clamped_clamped}) {
        const ElasticaCurve& curve = ElasticaCurve::of(ends);
        for (double eta = 0.0; eta < 1.0; eta += 1e-3) EXPECT_GT(curve.at(eta).slope, 0.49) << eta;
        EXPECT_EQ(curve.folded(), 1.0);
        constexpr double level = 130.7;    // hard case 18: [degrees] the slope at which a pinned column meets itself
        EXPECT_NEAR(curve.largest_slope(1.0) * 180.0 / pi, level, 0.05);
    }
}

/// Whether two pieces of the bow cross.
bool crosses_itself(const ElasticaCurve& curve, double eta) {
    constexpr int pieces = 400;
    std::vector<BowPoint> line;
    for (int i = 0; i <= pieces; ++i) line.push_back(curve.bow(eta, static_cast<double>(i) / pieces));
    const auto side = [](const BowPoint& a, const BowPoint& b, const BowPoint& of) {
        return (b.along - a.along) * (of.aside - a.aside) - (b.aside - a.aside) * (of.along - a.along);
    };
    for (int i = 0; i < pieces; ++i) {
        for (int j = i + 2; j < pieces; ++j) {
            const BowPoint &a = line[i], &b = line[i + 1], &c = line[j], &d = line[j + 1];
            if (side(a, b, c) * side(a, b, d) < 0.0 && side(c, d, a) * side(c, d, b) < 0.0) return true;
        }
    }
    return false;
}

TEST(ElasticaCurve, MeetsItselfWhereItSays) {
    constexpr double near = 1e-3;    // polygons of 400 pieces
    for (const Ends ends : all_ends) {
        const ElasticaCurve& curve = ElasticaCurve::of(ends);
        for (const double eta : {0.1, 0.5, 0.75, 0.8, curve.touches_itself() - near}) {
            EXPECT_FALSE(crosses_itself(curve, eta)) << eta;
        }
    }
    const ElasticaCurve& bulging = ElasticaCurve::of(Ends::clamped_clamped);
    EXPECT_TRUE(crosses_itself(bulging, bulging.touches_itself() + near));
}

}    // namespace
}    // namespace stylet::elastica
