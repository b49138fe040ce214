// What is advised once all is measured, and how much longer measuring takes.
#include "apps/study/advice.h"
#include "apps/study/pace.h"

#include <gtest/gtest.h>

#include <limits>

namespace stylet::study {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();

/// A setting with this error whose ticks take `median` and `p99` [µs].
Weighed setting(double error, double median, double p99) {
    return {.neighbour = {},
            .error = error,
            .timing = Timing{.median = median, .p99 = p99, .worst = p99, .waited = 0.0, .contended = false}};
}

Advice advice_on(std::vector<Weighed> settings) {
    Advice advice{};
    advice.wish = {.budget = 1e-3, .error = 0.05};
    advice.settings = std::move(settings);
    choose(advice);
    return advice;
}

TEST(Advice, TakesTheMostAccurateInTimeAndNamesTheCheapest) {
    const Advice advice =
        advice_on({setting(0.2, 1, 2), setting(0.04, 10, 20), setting(0.01, 500, 900), setting(0.001, 800, 1500)});
    EXPECT_EQ(advice.take, 2u);
    EXPECT_EQ(advice.nearest, 2u);
    EXPECT_EQ(advice.cheapest, 1u);
    EXPECT_EQ(advice.examined, 2u);
}

TEST(Advice, TakesNothingWhereNothingIsBothInTimeAndNearEnough) {
    const Advice advice = advice_on({setting(0.2, 1, 2), setting(0.1, 10, 20), setting(0.001, 800, 1500)});
    EXPECT_EQ(advice.take, std::nullopt);
    EXPECT_EQ(advice.nearest, 1u);
    EXPECT_EQ(advice.cheapest, 2u);
    EXPECT_EQ(advice.examined, 0u) << "the scene itself";
}

TEST(Advice, KeepsWithTheSceneWhereAnotherIsNoBetter) {
    EXPECT_EQ(advice_on({setting(0.01, 5, 6), setting(0.01, 5, 6)}).take, 0u);
}

TEST(Advice, TakesTheFirstOfThoseThatDifferByNothingThatCounts) {
    // 0.4 % nearer where 5 % are asked for, and a tenth cheaper.
    const Advice advice = advice_on({setting(0.022, 0.66, 20), setting(0.018, 0.60, 10)});
    EXPECT_EQ(advice.take, 0u);
    EXPECT_EQ(advice.cheapest, 0u);
    const Advice other = advice_on({setting(0.022, 0.67, 20), setting(0.016, 0.60, 10)});
    EXPECT_EQ(other.take, 1u);
    EXPECT_EQ(other.cheapest, 1u);
}

TEST(Advice, TakesNothingThatIsNotNearEnoughHoweverAlike) {
    EXPECT_EQ(advice_on({setting(0.053, 1, 2), setting(0.049, 1, 2)}).take, 1u);
}

TEST(Advice, PassesOverWhatHasNoErrorOrNoTime) {
    Weighed untimed = setting(0.0, 0, 0);
    untimed.timing.reset();
    const Advice advice = advice_on({untimed, setting(never, 1, 1), setting(0.04, 10, 20)});
    EXPECT_EQ(advice.take, 2u);
    EXPECT_EQ(advice_on({untimed, setting(never, 1, 1)}).nearest, std::nullopt);
}

TEST(Advice, TakesNoOtherRate) {
    Weighed slower = setting(0.0, 1, 1);
    slower.neighbour.changes = {{"run.rate", "500 Hz"}};
    const Advice advice = advice_on({setting(0.04, 10, 20), slower});
    EXPECT_EQ(advice.take, 0u);
    EXPECT_EQ(advice.cheapest, 0u);
}

TEST(Advice, AsksNinetyNineOfAHundredTicksToBeInTime) {
    const Wish wish{.budget = 1e-3, .error = 0.05};
    EXPECT_TRUE(setting(0.0, 10, 1000).in_time(wish));
    EXPECT_FALSE(setting(0.0, 10, 1001).in_time(wish));
}

TEST(Advice, JudgesABusyMachineByItsMedian) {
    const Wish wish{.budget = 1e-3, .error = 0.05};
    Weighed busy = setting(0.0, 10, 5000);
    EXPECT_FALSE(busy.in_time(wish));
    busy.timing->contended = true;
    EXPECT_TRUE(busy.in_time(wish));
    busy.timing->median = 1001;
    EXPECT_FALSE(busy.in_time(wish));
}

TEST(Costliest, IsTheScenesOwnModelsWhereNoOtherIsClearlyCostlier) {
    EXPECT_EQ(costliest({setting(never, 10, 20), setting(never, 11, 20), setting(never, 19, 90)}), 0u);
    EXPECT_EQ(costliest({setting(never, 10, 20), setting(never, 21, 20)}), 1u);
}

TEST(Costliest, IsTheFirstOfSeveralThatAreAlike) {
    EXPECT_EQ(costliest({setting(never, 1, 2), setting(never, 100, 200), setting(never, 104, 200), setting(never, 97, 200)}), 1u);
    EXPECT_EQ(costliest({setting(never, 1, 2), setting(never, 40, 80), setting(never, 97, 200), setting(never, 100, 200)}), 2u);
}

TEST(Costliest, PassesOverWhatDidNotRunToItsEnd) {
    Weighed broken = setting(never, 500, 900), untimed = setting(never, 0, 0);
    broken.why = "fault: no equilibrium";
    untimed.timing.reset();
    EXPECT_EQ(costliest({untimed, setting(never, 5, 9), broken}), 1u);
    EXPECT_EQ(costliest({untimed, broken}), 0u);
}

TEST(Pace, ExpectsOfEachKindWhatItsRunsTook) {
    Pace pace;
    pace.expect(3, 2, 1);
    EXPECT_FALSE(pace.known());
    pace.done(Pace::models, 2.0);
    // Two models of 2 s, a reference of four times the longest, two steps and an omission as the first run.
    EXPECT_DOUBLE_EQ(pace.left(Pace::models, 0.0, 0.0), 2 * 2.0 + 4 * 2.0 + 2 * 2.0 + 2.0);
    // The one under way has done a quarter in 1 s.
    EXPECT_DOUBLE_EQ(pace.left(Pace::models, 0.25, 1.0), 3.0 + 2.0 + 4 * 2.0 + 2 * 2.0 + 2.0);
    pace.done(Pace::models, 6.0);
    pace.done(Pace::models, 1.0);
    pace.done(Pace::references, 20.0);
    EXPECT_DOUBLE_EQ(pace.left(Pace::steps, 0.5, 4.0), 4.0 + 2.0 + 2.0);
    EXPECT_EQ(pace.count(), 7u);
    EXPECT_EQ(pace.count_done(), 4u);
}

TEST(Pace, CountsMoreThanWasExpected) {
    Pace pace;
    pace.expect(1, 0, 0);
    pace.done(Pace::models, 1.0);
    pace.done(Pace::omissions, 1.0);
    EXPECT_EQ(pace.count(), 3u);
    EXPECT_EQ(pace.count_done(), 2u);
}

}    // namespace
}    // namespace stylet::study
