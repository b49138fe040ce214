// Columns pushed to their critical load and past it: what they bear at most, from where they bow, and whether they come back.
#include "convergence.h"
#include "equilibrium.h"
#include "known_rods.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <vector>

namespace stylet::rod {
namespace {

using std::numbers::pi;
constexpr int x = Equilibrium::x, y = Equilibrium::y, z = Equilibrium::z;

// ---- The limit load of a clamped-pinned column: the pin turns the force aside ----

const double clamped_pinned_load = std::pow(4.493409457909064, 2);    // [EI/L²]

struct Peak {
    double load, span;
};

Peak exact_peak() {
    Peak peak{0.0, 1.0};
    for (double k = 0.5; k < 0.8; k += 1e-4) {
        const Column column = clamped_pinned(k);
        if (column.load > peak.load) peak = {column.load, column.span};
    }
    return peak;
}

// Pushed in by steps; the largest force of the hand, of a parabola through the three largest steps.
Peak pushed_in(int elements, bool printed) {
    Equilibrium rod(unit_rod(elements, true, clamped_pinned_load));
    pin_tip(rod);
    const int middle = 3 * elements / 5;    // where it bows most
    EXPECT_TRUE(bow(rod, middle, 0.98));
    std::vector<Peak> curve;
    constexpr double step = 0.01, farthest = 0.3;
    for (double span = 0.98; span > farthest; span -= step) {
        rod.held[rod.unknown(elements, z)] = 1.0 - span;
        EXPECT_TRUE(rod.solve());
        EXPECT_EQ(rod.negatives(), 0) << "at rest with its ends held, but not stable";
        curve.push_back({rod.reaction(rod.unknown(elements, z)), span});
    }
    const auto most =
        std::max_element(curve.begin() + 1, curve.end() - 1, [](const Peak& a, const Peak& b) { return a.load < b.load; });
    const double before = most[-1].load, at = most->load, after = most[1].load;
    if (printed) {
        for (std::size_t i = 0; i < curve.size(); i += 4)
            std::printf("clamped-pinned, span %.2f L: %.4f of the critical load\n", curve[i].span,
                        curve[i].load / clamped_pinned_load);
    }
    const double offset = 0.5 * (before - after) / (before - 2.0 * at + after);
    return {at - 0.25 * (before - after) * offset, most->span - step * offset};
}

TEST(BowedRod, BearsNoMoreThanItsLimitLoadBetweenAClampAndAPin) {
    const Peak exact = exact_peak();
    const Peak found = pushed_in(40, true);
    std::printf("clamped-pinned limit load: %.4f of the critical load at a span of %.3f L; elastica %.4f at %.3f\n",
                found.load / clamped_pinned_load, found.span, exact.load / clamped_pinned_load, exact.span);
    EXPECT_NEAR(found.load / clamped_pinned_load, 1.14, 0.0114);
    expect_second_order(
        {{"clamped-pinned: limit load", exact.load, 9.5}},
        [](int elements) { return std::vector{only(pushed_in(elements, false).load)}; }, 80);
}

// ---- About the critical load: hard cases 13 to 16, on a pinned-pinned column ----

struct Pushed : Equilibrium {
    Pushed(int elements, double imperfection) : Equilibrium(bowed(elements, imperfection)) {
        pin_tip(*this);
        held[unknown(elements / 2, y)] = 0.0;
    }

    // Its stress-free shape is a half sine of this height.
    static ChainSetup bowed(int elements, double imperfection) {
        ChainSetup setup = unit_rod(elements, false, 10.0);
        for (int joint = 1; joint < elements; ++joint)
            setup.natural_curvature[joint] = -imperfection * pi * pi * std::sin(pi * joint / elements);
        return setup;
    }

    void push(double force) { load[unknown(last(), z)] = force; }
    [[nodiscard]] double deflection() const { return displacement(last() / 2, x); }
};

// This chain's own, shortened as it is under it.
double critical_load(int elements) {
    Pushed rod(elements, 0.0);
    double least = 9.0, most = 11.0;
    for (int halvings = 0; halvings < 60; ++halvings) {
        const double middle = 0.5 * (least + most);
        rod.push(middle);
        EXPECT_TRUE(rod.solve());
        (rod.negatives() > 0 ? most : least) = middle;
    }
    return 0.5 * (least + most);
}

// F = P_cr (1 ± 10^-k), k = 2…12.
TEST(RodNearItsCriticalLoad, BowsByTheRootOfWhatIsAboveItAndNotAtAllBelow) {
    constexpr int elements = 10;    // rounding shifts the critical load by 1e-16 n⁴
    const double critical = critical_load(elements);
    Pushed rod(elements, 0.0);
    ASSERT_TRUE(bow(rod, elements / 2, 0.98));
    rod.held.erase(rod.unknown(elements, z));
    double limit = 0.0;
    for (int k = 2; k <= 12; ++k) {
        const double excess = std::pow(10.0, -k), root = std::sqrt(excess);
        rod.push(critical * (1.0 + excess));
        ASSERT_TRUE(rod.solve(1e-6 * root)) << "at 1 + 1e-" << k;
        EXPECT_EQ(rod.negatives(), 0);
        Pushed below = rod;
        below.push(critical * (1.0 - excess));
        ASSERT_TRUE(below.solve(1e-6 * root)) << "at 1 - 1e-" << k;
        EXPECT_EQ(below.negatives(), 0);
        const double over_root = rod.deflection() / root;
        std::printf("P_cr (1 +- 1e-%02d): deflection %.3e L above, %.6f of the root, %.1e L below\n", k, rod.deflection(),
                    over_root, below.deflection());
        EXPECT_LE(std::abs(below.deflection()), 1e-6 * root);
        if (k == 4) limit = over_root;
        if (k <= 4) continue;
        // The next term of the elastica's load, and the critical load's last bits.
        EXPECT_NEAR(over_root, limit, 1e-4 + 1e-14 / excess);
    }
    // P/P_cr = 1 + π²w²/8L². Of second order in the elements' length: 0.5 % off with forty.
    constexpr double ten_elements = 0.08;
    EXPECT_NEAR(limit, std::sqrt(8.0) / pi, ten_elements);
}

constexpr int elements = 40;

TEST(RodAboveItsCriticalLoad, StaysStraightWhereNothingTellsItsSidesApartButIsNotStableThere) {
    Pushed rod(elements, 0.0);
    rod.push(1.1 * pi * pi);
    ASSERT_TRUE(rod.settle());
    EXPECT_EQ(rod.deflection(), 0.0);
    EXPECT_EQ(rod.negatives(), 1);
}

double deflection_at(double load, double imperfection) {
    Pushed rod(elements, imperfection);
    rod.push(load);
    EXPECT_TRUE(rod.settle());
    EXPECT_EQ(rod.negatives(), 0);
    return rod.deflection();
}

TEST(RodAboveItsCriticalLoad, BowsToTheSideOfItsImperfectionEveryTimeTheSame) {
    const double load = 1.1 * pi * pi, there = deflection_at(load, 1e-5), back = deflection_at(load, -1e-5);
    EXPECT_GT(there, 0.1);
    EXPECT_NEAR(back, -there, 1e-9);
    EXPECT_EQ(deflection_at(load, 1e-5), there) << "to the last bit";
}

TEST(RodAboveItsCriticalLoad, BowsAsFarHoweverSmallItsImperfection) {
    const double load = 1.1 * pi * pi;
    double before = 0.0, change_before = 0.0;
    for (int k = 3; k <= 9; ++k) {
        const double imperfection = std::pow(10.0, -k), found = deflection_at(load, imperfection),
                     change = std::abs(found - before);
        std::printf("imperfection 1e-%d L: deflection %.12f L\n", k, found);
        // What an imperfection adds is in proportion to it.
        if (k > 4) {
            EXPECT_NEAR(change, 0.1 * change_before, 0.01 * change_before + 1e-10);
        }
        before = found;
        change_before = change;
    }
}

TEST(RodNearItsCriticalLoad, ComesBackTheWayItWent) {
    Pushed rod(elements, 1e-4);
    const double critical = critical_load(elements);
    std::vector<double> there;
    constexpr int steps = 60;
    for (int step = 0; step <= steps; ++step) {
        rod.push(1.2 * critical * step / steps);
        ASSERT_TRUE(rod.settle());
        there.push_back(rod.deflection());
    }
    double apart = 0.0;
    for (int step = steps; step >= 0; --step) {
        rod.push(1.2 * critical * step / steps);
        ASSERT_TRUE(rod.settle());
        apart = std::max(apart, std::abs(rod.deflection() - there[step]));
    }
    std::printf("to 1.2 of the critical load and back: deflected by %.4f L, on the way back off by %.1e L at most\n",
                there.back(), apart);
    EXPECT_GT(there.back(), 0.2);
    EXPECT_LE(apart, 1e-6);
}

}    // namespace
}    // namespace stylet::rod
