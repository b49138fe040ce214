#include "apps/study/orders.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <limits>
#include <random>
#include <vector>

namespace stylet::study {
namespace {

constexpr double rounding = 1e-12;    // sums of ten logarithms

struct Points {
    std::vector<double> numbers, errors;

    /// error(number) at `count` numbers from `first`, each `ratio` times the one before.
    template <class Error>
    Points(double first, double ratio, int count, Error error) {
        double number = first;
        for (int i = 0; i < count; ++i, number *= ratio) {
            numbers.push_back(number);
            errors.push_back(error(number));
        }
    }

    [[nodiscard]] std::optional<FittedOrder> order() const {
        const auto found = fitted_order("rod", "needle.rod.nodes", numbers, errors);
        if (found) std::printf("order %.4f from %d points down to %.3g\n", found->order, found->points, found->least_error);
        return found;
    }
};

TEST(FittedOrder, OfAPowerIsItsExponent) {
    const auto elements = Points(5.0, 2.0, 6, [](double n) { return 3.0 / (n * n); }).order();
    ASSERT_TRUE(elements);
    EXPECT_NEAR(elements->order, -2.0, rounding);
    EXPECT_EQ(elements->points, 6);
    EXPECT_NEAR(elements->least_error, 3.0 / (160.0 * 160.0), rounding);
    EXPECT_EQ(elements->series, "rod");
    EXPECT_EQ(elements->key, "needle.rod.nodes");
    EXPECT_NEAR(Points(4e-3, 0.5, 5, [](double dt) { return 7.0 * dt; }).order()->order, 1.0, rounding);
    EXPECT_NEAR(Points(0.25e-3, 2.0, 5, [](double dt) { return 7.0 * dt; }).order()->order, 1.0, rounding) << "from the fine end";
}

TEST(FittedOrder, IsThatOfLeastSquares) {
    // log2 error 0, −1, −3 over log2 number 0, 1, 2: the line through them falls by 1.5.
    EXPECT_NEAR(Points(1.0, 2.0, 3, [](double n) { return n == 1.0   ? 1.0
                                                          : n == 2.0 ? 0.5
                                                                     : 0.125; }).order()->order, -1.5,
                rounding);
}

TEST(FittedOrder, LeavesOutTheFloor) {
    constexpr double bent = 0.15;    // a third of a kept error may be the floor's
    for (const double floor : {1e-3, 1e-4, 1e-5}) {
        const auto found = Points(2.0, 2.0, 12, [&](double n) { return 1.0 / (n * n) + floor; }).order();
        ASSERT_TRUE(found);
        EXPECT_NEAR(found->order, -2.0, bent);
        EXPECT_GT(found->least_error, 2.9 * floor);
        const auto step = Points(1.0, 0.5, 22, [&](double dt) { return dt + floor; }).order();
        ASSERT_TRUE(step);
        EXPECT_NEAR(step->order, 1.0, bent);
        EXPECT_LT(step->points, 22);
    }
}

TEST(FittedOrder, IsNotTakenInByADipBeforeTheFloor) {
    // The error changes its sign near n = 10: its size dips there, and then is the floor's.
    const auto found = Points(1.0, 2.0, 9, [](double n) { return std::abs(1.0 / (n * n) - 0.01); }).order();
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->order, -2.0, 0.2);
    EXPECT_EQ(found->points, 3);
}

TEST(FittedOrder, BeginsWhereTheErrorIsLargest) {
    const auto found = Points(1.0, 2.0, 6, [](double n) { return n == 1.0 ? 0.05 : 4.0 / (n * n); }).order();
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->order, -2.0, rounding);
    EXPECT_EQ(found->points, 5);
}

TEST(FittedOrder, IsNoneWithoutThreePointsThatFall) {
    const auto square = [](double n) { return 1.0 / (n * n); };
    EXPECT_FALSE(Points(1.0, 2.0, 2, square).order());
    EXPECT_TRUE(Points(1.0, 2.0, 3, square).order());
    EXPECT_FALSE(Points(1.0, 2.0, 8, [](double) { return 0.5; }).order());
    EXPECT_FALSE(Points(1.0, 2.0, 8, [](double) { return 0.0; }).order());
    EXPECT_FALSE(Points(1.0, 2.0, 8, [](double) { return std::numeric_limits<double>::infinity(); }).order());
    EXPECT_FALSE(Points(1.0, 1.0, 8, square).order()) << "one number eight times";
    EXPECT_FALSE(Points(1.0, 2.0, 0, square).order());
    EXPECT_FALSE(Points(1.0, 2.0, 8, [](double n) { return n < 4.0 ? 1.0 / n : 0.4; }).order());
}

TEST(FittedOrder, LeavesOutErrorsThatAreNoneAndJoinsThoseOfOneNumber) {
    Points points(1.0, 2.0, 5, [](double n) { return 1.0 / (n * n); });
    points.numbers.insert(points.numbers.end(), {32.0, 64.0, 4.0});
    points.errors.insert(points.errors.end(), {0.0, std::nan(""), 1.0 / 16.0});
    const auto found = points.order();
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->order, -2.0, rounding);
    EXPECT_EQ(found->points, 5);
}

TEST(FittedOrder, StandsAFewPerCentOfNoise) {
    std::mt19937 random(1);
    std::normal_distribution<double> noise(0.0, 0.03);
    const auto found = Points(5.0, 2.0, 6, [&](double n) { return std::exp(noise(random)) / (n * n); }).order();
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->order, -2.0, 0.05) << "0.03 in each logarithm over five doublings";
}

}    // namespace
}    // namespace stylet::study
