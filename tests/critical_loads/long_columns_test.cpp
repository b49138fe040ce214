// The converged load of a column in homogeneous tissue against what is known of it.
#include "layered_column.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <limits>
#include <numbers>
#include <random>

namespace stylet {
namespace {

using contract::Given;
using std::numbers::pi;

/// √(kEI) of a column of one bed [N].
double long_load(const LayeredColumn& column) {
    return std::sqrt(column.beds.front().modulus * LayeredColumn::bending_stiffness());
}

TEST(WinklerLongColumn, WithAFreeEndTendsToTheRootOfModulusTimesStiffness) {
    struct Row {
        double slenderness;    // l (k/EI)^¼
        double ratio;          // to √(kEI)
        double last_digit;
    };
    for (const Row& row : {Row{2.49, 1.258, 0.6e-3}, Row{4.97, 1.012, 0.6e-3}, Row{9.95, 1.0001, 0.6e-4}}) {
        const LayeredColumn column = homogeneous(row.slenderness);
        const double ratio = column.load("winkler") / long_load(column);
        std::printf("l (k/EI)^1/4 = %.2f: %.5f sqrt(k EI)\n", row.slenderness, ratio);
        EXPECT_NEAR(ratio, row.ratio, row.last_digit);
    }
}

TEST(WinklerLongColumn, HeldAtBothEndsTendsToTwiceAsMuch) {
    constexpr double shortness = 0.01;    // relative: held ends lift the load by the square of (6/50)
    for (const Ends ends : {Ends::pinned_pinned, Ends::clamped_pinned, Ends::clamped_clamped}) {
        const LayeredColumn column = homogeneous(50.0, ends);
        const double ratio = column.load("winkler") / long_load(column);
        std::printf("ends %d, l (k/EI)^1/4 = 50: %.5f sqrt(k EI)\n", static_cast<int>(ends), ratio);
        EXPECT_NEAR(ratio, 2.0, 2.0 * shortness);
    }
}

// P l²/EI = min over m of m²π² + (l (k/EI)^¼)⁴/(m²π²): m half waves (Timoshenko and Gere 1961, section 2.10).
TEST(WinklerLongColumn, PinnedAtBothEndsBucklesInTheRightNumberOfHalfWaves) {
    constexpr double fourth_order = 3.0 / 720.0;    // of waves per element to the fourth, from the elements' next Taylor term
    for (const double slenderness : {1.0, 3.0, 6.0, 10.0, 20.0, 50.0}) {
        double exact = std::numeric_limits<double>::infinity();
        for (int m = 1; m < 100; ++m) exact = std::min(exact, m * m * pi * pi + std::pow(slenderness, 4) / (m * m * pi * pi));
        const LayeredColumn column = homogeneous(slenderness, Ends::pinned_pinned);
        const double load = column.load("winkler") * std::pow(column.length(), 2) / LayeredColumn::bending_stiffness();
        const double per_element = std::max(slenderness, pi) / 64.0;
        std::printf("l (k/EI)^1/4 = %4.0f: %.9f of the exact load\n", slenderness, load / exact);
        EXPECT_GT(load, exact * (1.0 - 1e-8));    // an upper bound, but for rounding
        EXPECT_LT(load, exact * (1.0 + 1e-8 + fourth_order * std::pow(per_element, 4)));
    }
}

/// The exponent with which the error falls from `coarse` to twice as many elements, from three meshes.
double order(LayeredColumn column, std::int64_t coarse) {
    std::array<double, 3> loads;
    for (std::size_t i = 0; i < 3; ++i) loads[i] = column.load("winkler", Given{{"elements", coarse << i}});
    return std::log2((loads[0] - loads[1]) / (loads[1] - loads[2]));
}

TEST(WinklerConvergence, IsOfFourthOrder) {
    constexpr double of_order = 0.05;    // the finest mesh is still coarse
    for (const Ends ends : {Ends::clamped_free, Ends::pinned_pinned, Ends::clamped_pinned, Ends::clamped_clamped}) {
        const double in_tissue = order(homogeneous(8.0, ends), 16);
        std::printf("ends %d: order %.3f in tissue", static_cast<int>(ends), in_tissue);
        EXPECT_NEAR(in_tissue, 4.0, of_order);
        // Clamped at both ends in air, the bound that the load is looked for under is the load itself.
        const double in_air = ends == Ends::clamped_clamped ? 4.0 : order({.beds = {}, .free_length = 0.05, .ends = ends}, 8);
        std::printf(", %.3f in air\n", in_air);
        EXPECT_NEAR(in_air, 4.0, of_order);
    }
}

/// By how much 64 elements differ from 128, relative.
double gap(const LayeredColumn& column) {
    return std::abs(column.load("winkler") / column.load("winkler", Given{{"elements", std::int64_t{128}}}) - 1.0);
}

TEST(WinklerConvergence, IsReachedByColumnsOfVeryUnevenParts) {
    constexpr double elements = 1e-4;    // relative; elements of one length leave ten times as much
    struct Row {
        const char* what;
        LayeredColumn column;
    };
    for (const Row& row :
         {Row{"200 mm in air, 0.3 mm in soft tissue", {{{0.3e-3, 5e3}}, 0.2}},
          Row{"200 mm in air, 1 mm in bone", {{{1e-3, 1e9}}, 0.2}}, Row{"200 mm in air, 40 mm in bone", {{{40e-3, 1e9}}, 0.2}},
          Row{"1 mm of gel between two plates of bone", {{{10e-3, 1e9}, {1e-3, 1e3}, {10e-3, 1e9}}, 0.05}},
          Row{"a stiff skin on soft tissue", {{{0.2e-3, 1e9}, {80e-3, 2e4}}, 0.1}}}) {
        double worst = 0.0;
        for (const Ends ends : {Ends::clamped_free, Ends::pinned_pinned, Ends::clamped_pinned, Ends::clamped_clamped}) {
            LayeredColumn column = row.column;
            column.ends = ends;
            worst = std::max(worst, gap(column));
        }
        std::printf("%s: 64 elements against 128: %.1e\n", row.what, worst);
        EXPECT_LT(worst, elements) << row.what;
    }
}

TEST(WinklerConvergence, IsWithinAThousandthWhereTheTissueIsNotTooLong) {
    constexpr double elements = 1e-3;    // relative: what the plugin states
    constexpr double longest = 50.0;     // sum of d (k/EI)^¼
    std::mt19937 random(5);
    const auto decades = [&random](double least, double greatest) {
        return std::pow(10.0, std::uniform_real_distribution<double>(least, greatest)(random));
    };
    double worst = 0.0;
    for (int i = 0; i < 500; ++i) {
        LayeredColumn column{.beds = {}, .free_length = i % 3 == 0 ? 0.0 : decades(-3.0, -0.7), .ends = static_cast<Ends>(i % 4)};
        double slenderness = 0.0;
        for (int layer = 0; layer < 1 + i % 5; ++layer) {
            column.beds.push_back({decades(-3.5, -1.0), decades(3.0, 8.0)});
            slenderness +=
                column.beds.back().thickness * std::pow(column.beds.back().modulus / LayeredColumn::bending_stiffness(), 0.25);
        }
        if (slenderness < longest) worst = std::max(worst, gap(column));
    }
    worst = std::max(worst, gap(homogeneous(longest)));
    std::printf("500 random columns: 64 elements against 128: %.1e at worst\n", worst);
    EXPECT_LT(worst, elements);
}

TEST(Winkler, ChangesSmoothlyWhileANeedleGoesIn) {
    constexpr double step = 20e-6;       // [m]
    constexpr double of_slope = 0.02;    // the slope may change by this share of its largest from step to step
    const LayeredColumn beds{.beds = {{20e-3, 3e4}, {30e-3, 3e5}, {50e-3, 1e4}}, .ends = Ends::clamped_pinned};
    const contract::Case scene = beds.with({});
    const auto model = contract::make<BucklingModel>(PLUGIN_FOLDER "/winkler.so", scene);
    std::vector<double> loads;
    for (int i = 0; i <= 5000; ++i) {
        Column column = beds.column();
        column.inserted = column.depth = i * step;
        column.free_length = 0.15 - column.inserted;
        loads.push_back(model->critical_load(column));
    }
    double steepest = 0.0, kink = 0.0;    // [N] a step
    for (std::size_t i = 2; i < loads.size(); ++i) {
        steepest = std::max(steepest, std::abs(loads[i] - loads[i - 1]));
        kink = std::max(kink, std::abs(loads[i] - 2.0 * loads[i - 1] + loads[i - 2]));
    }
    std::printf("0 to 100 mm in: from %.3f to %.3f N, %.3f N/mm at most, changing by %.4f N/mm a step at most\n", loads.front(),
                loads.back(), 1e-3 * steepest / step, 1e-3 * kink / step);
    EXPECT_LT(kink, of_slope * steepest);
}

}    // namespace
}    // namespace stylet
