#include "core/run/durations.h"

#include <gtest/gtest.h>

namespace stylet::core {
namespace {

constexpr double bin_width = 0.01;    // of a duration: what Durations promises

TEST(Durations, GiveTheirQuantilesToAPercent) {
    for (const double unit : {0.05, 1.0, 137.0, 1e6}) {    // [µs]
        Durations durations;
        for (int i = 1; i <= 1000; ++i) durations.add(unit * i);
        EXPECT_NEAR(durations.quantile(0.5), 500.0 * unit, bin_width * 500.0 * unit);
        EXPECT_NEAR(durations.quantile(0.99), 990.0 * unit, bin_width * 990.0 * unit);
        EXPECT_EQ(durations.worst(), 1000.0 * unit);
    }
}

TEST(Durations, OfNothingAreNothing) {
    EXPECT_EQ(Durations().quantile(0.5), 0.0);
    EXPECT_EQ(Durations().worst(), 0.0);
    EXPECT_EQ(Durations().mean(), 0.0);
}

TEST(Durations, GiveTheirMeanExactly) {
    Durations durations;
    for (const double duration : {1.0, 2.0, 6.0}) durations.add(duration);
    EXPECT_EQ(durations.mean(), 3.0);
}

TEST(Durations, TakeTheShortestAndTheLongestToo) {
    Durations durations;
    durations.add(0.0);
    durations.add(1e12);
    EXPECT_EQ(durations.worst(), 1e12);
    EXPECT_LE(durations.quantile(0.5), 0.011);
}

}    // namespace
}    // namespace stylet::core
