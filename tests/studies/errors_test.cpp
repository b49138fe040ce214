#include "apps/study/errors.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <limits>
#include <numbers>

namespace stylet::study {
namespace {

using testing::HasSubstr;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double rounding = 1e-12;    // sums of a few thousand numbers around one

Outcome value(double y) {
    return {.x = {}, .y = {y}};
}

/// The curve y(x) on `count` samples from `first` to `last`.
template <class Function>
Outcome curve(double first, double last, int count, Function y) {
    Outcome outcome;
    for (int i = 0; i < count; ++i) {
        const double x = first + (last - first) * i / (count - 1);
        outcome.x.push_back(x);
        outcome.y.push_back(y(x));
    }
    return outcome;
}

void expect_none(const Outcome& mine, const Outcome& reference, const std::string& why) {
    const ErrorOfOutcome found = error_of(mine, reference);
    EXPECT_EQ(found.error, infinity);
    EXPECT_THAT(found.why, HasSubstr(why));
}

TEST(ErrorOfAValue, IsItsShareOfTheReference) {
    EXPECT_NEAR(error_of(value(1.1), value(1.0)).error, 0.1, rounding);
    EXPECT_NEAR(error_of(value(-1.9), value(-2.0)).error, 0.05, rounding);
    EXPECT_EQ(error_of(value(2.0), value(2.0)).error, 0.0);
    EXPECT_EQ(error_of(value(2.0), value(2.0)).why, "");
}

TEST(ErrorOfACurve, OfAShiftIsTheShiftOverTheLargest) {
    const Outcome mine = curve(0.0, 2.0, 101, [](double x) { return x + 0.1; });
    const Outcome reference = curve(0.0, 2.0, 401, [](double x) { return x; });
    EXPECT_NEAR(error_of(mine, reference).error, 0.1 / 2.0, rounding);
}

TEST(ErrorOfACurve, OfAHalfSineIsItsRms) {
    const Outcome mine = curve(0.0, 1.0, 1001, [](double x) { return 1.0 + 0.03 * std::sin(std::numbers::pi * x); });
    const Outcome reference = curve(0.0, 1.0, 1001, [](double) { return 1.0; });
    const double error = error_of(mine, reference).error;
    std::printf("RMS of 0.03 sin(pi x): %.12f, known %.12f\n", error, 0.03 / std::numbers::sqrt2);
    EXPECT_NEAR(error, 0.03 / std::numbers::sqrt2, rounding) << "the trapezoid rule is exact for a whole period";
}

TEST(ErrorOfACurve, WeighsBySteps) {
    // 9 samples in the first tenth, off by 1; the rest of the range is right: 10 % of it counts, not 90 %.
    Outcome mine = curve(0.0, 0.1, 9, [](double) { return 11.0; });
    mine.x.insert(mine.x.end(), {0.1 + 1e-9, 1.0});
    mine.y.insert(mine.y.end(), {10.0, 10.0});
    const Outcome reference = curve(0.0, 1.0, 101, [](double) { return 10.0; });
    constexpr double jump = 1e-8;    // its own nanometre counts half
    EXPECT_NEAR(error_of(mine, reference).error, std::sqrt(0.1) / 10.0, jump);
}

TEST(ErrorOfACurve, IsTakenAtThePointsOfACurveReadOffAPicture) {
    const auto parabola = [](double x) { return x * x; };
    const Outcome picture = curve(0.0, 1.0, 5, parabola), mine = curve(0.0, 1.0, 1001, parabola);
    EXPECT_NEAR(error_of(mine, picture).error, 0.0, rounding) << "the straight lines between its points are not the curve";
    EXPECT_NEAR(error_of(picture, mine).error, 0.0, rounding);
}

TEST(ErrorOfACurve, ComparesWhereBothAreKnown) {
    const Outcome mine = curve(-1.0, 3.0, 401, [](double x) { return x < 0.0 || x > 2.0 ? 100.0 : 1.1; });
    const Outcome reference = curve(0.0, 2.0, 41, [](double) { return 1.0; });
    EXPECT_NEAR(error_of(mine, reference).error, 0.1, rounding);
}

TEST(ErrorOfACurve, TakesTheLastOfAHold) {
    const Outcome mine{.x = {0.0, 1.0, 1.0, 1.0, 2.0}, .y = {0.0, 9.0, 5.0, 1.0, 2.0}};
    const Outcome reference{.x = {0.0, 1.0, 2.0}, .y = {0.0, 1.0, 2.0}};
    EXPECT_EQ(error_of(mine, reference).error, 0.0);
    const Outcome by_rounding{.x = {0.0, 1.0, 1.0 - 1e-15, 2.0}, .y = {0.0, 5.0, 1.0, 2.0}};
    EXPECT_EQ(error_of(by_rounding, reference).error, 0.0);
}

TEST(ErrorOfACurve, IsNoneWhereARunEndedEarly) {
    const auto line = [](double x) { return 1.0 + x; };
    const Outcome reference = curve(0.0, 1.0, 101, line);
    EXPECT_EQ(error_of(curve(0.0, 0.995, 101, line), reference).why, "");
    expect_none(curve(0.0, 0.615, 101, line), reference, "covers 61.5 % of the reference: found 0 to 0.615, wanted 0 to 1");
    expect_none(curve(2.0, 3.0, 101, line), reference, "covers 0 %");
}

TEST(ThereIsNoError, WithoutTwoFiniteOutcomes) {
    const Outcome never{.x = {}, .y = {}, .missing = "never punctured"};
    expect_none(never, value(1.0), "never punctured");
    expect_none(value(1.0), never, "the reference: never punctured");
    expect_none(value(std::nan("")), value(1.0), "not finite");
    expect_none(value(1.0), value(infinity), "the reference: not finite");
    expect_none(value(1.0), value(0.0), "the reference is 0");
    expect_none(value(1.0), {.x = {0.0, 1.0}, .y = {0.0, 1.0}}, "found one value, the reference is a curve");
    expect_none({.x = {}, .y = {}}, value(1.0), "found 0 values, wanted one");
    expect_none({.x = {0.0, 1.0}, .y = {0.0}}, value(1.0), "found 1 values, wanted 2");
}

TEST(ThereIsNoError, OfACurveThatMovesBackOrNowhereOrIsZero) {
    const Outcome line{.x = {0.0, 1.0, 2.0}, .y = {1.0, 1.0, 1.0}};
    expect_none({.x = {0.0, 2.0, 1.5}, .y = {1.0, 1.0, 1.0}}, line, "moves back from 2 to 1.5");
    expect_none(line, {.x = {0.0, 2.0, 1.5}, .y = {1.0, 1.0, 1.0}}, "the reference: moves back");
    expect_none({.x = {1.0, 1.0}, .y = {1.0, 1.0}}, line, "never moves");
    expect_none(line, {.x = {0.0, 2.0}, .y = {0.0, 0.0}}, "the reference is 0 everywhere");
}

TEST(ErrorsOfCases, AreQuantilesBetweenTheOrderedErrors) {
    // 0.01 .. 1.00: the quantile at share q is 0.01 + 0.99 q.
    std::vector<double> errors;
    for (int i = 100; i > 0; --i) errors.push_back(0.01 * i);
    const ErrorOfCases found = errors_of_cases(errors, Judge::p95);
    EXPECT_NEAR(found.median, 0.505, rounding);
    EXPECT_NEAR(found.p95, 0.9505, rounding);
    EXPECT_NEAR(found.worst, 1.0, rounding);
    EXPECT_EQ(found.judged, found.p95);
    EXPECT_EQ(errors_of_cases(errors, Judge::median).judged, found.median);
    EXPECT_EQ(errors_of_cases(errors, Judge::worst).judged, found.worst);
    EXPECT_NEAR(errors_of_cases({3.0, 4.0}, Judge::rms).judged, std::sqrt(12.5), rounding);
    EXPECT_EQ(errors_of_cases({0.2}, Judge::median).p95, 0.2);
}

TEST(ErrorsOfCases, AreInfiniteOnlyWhereAnInfiniteOneReaches) {
    const ErrorOfCases found = errors_of_cases({0.1, 0.2, 0.3, 0.4, infinity}, Judge::median);
    EXPECT_EQ(found.judged, 0.3);
    EXPECT_EQ(found.p95, infinity);
    EXPECT_EQ(found.worst, infinity);
    EXPECT_EQ(errors_of_cases({0.1, std::nan("")}, Judge::median).judged, infinity) << "no number is no small error";
    EXPECT_EQ(errors_of_cases({0.1, 0.2, infinity}, Judge::rms).judged, infinity);
    EXPECT_EQ(errors_of_cases({}, Judge::rms).judged, infinity);
    EXPECT_EQ(errors_of_cases({}, Judge::worst).median, infinity);
}

}    // namespace
}    // namespace stylet::study
