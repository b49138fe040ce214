#include "apps/study/verdict.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace stylet::study {
namespace {

using testing::ElementsAre;

constexpr double infinity = std::numeric_limits<double>::infinity();

struct Point {
    const char* label;
    double error;          // relative
    double median, p99;    // [µs]
};

Result result_of(Timed timed, const std::vector<Point>& points) {
    Result result{.title = "",
                  .question = "",
                  .scene = "",
                  .measured = "",
                  .reference = "",
                  .judged = "",
                  .timed = timed,
                  .repetitions = 1,
                  .threads = 1,
                  .machine = {},
                  .command = ""};
    for (const Point& point : points) {
        SettingResult setting;
        setting.series = "rod";
        setting.label = point.label;
        setting.error = {point.error, point.error, point.error, point.error};
        if (timed != Timed::nothing) setting.timing = Timing{.median = point.median, .p99 = point.p99, .worst = 2.0 * point.p99};
        result.settings.push_back(setting);
    }
    add_verdict(result);
    return result;
}

std::vector<std::string> front_of(const Result& result) {
    std::vector<std::string> labels;
    for (const SettingResult& setting : result.settings) {
        if (setting.on_front) labels.push_back(setting.label);
    }
    return labels;
}

const std::vector<Point> usual{{"6 nodes", 0.08, 9.0, 12.0},         {"11 nodes", 0.017, 17.0, 20.0},
                               {"21 nodes", 0.0042, 38.0, 45.0},     {"41 nodes", 0.00104, 120.0, 150.0},
                               {"81 nodes", 0.00026, 640.0, 1300.0}, {"161 nodes", 0.00006, 2100.0, 2600.0}};

TEST(Verdict, NamesTheCheapestUnderEachLimitAndTheMostAccurateInTime) {
    EXPECT_THAT(
        result_of(Timed::tick, usual).verdict,
        ElementsAre("Cheapest under 1 %: rod, 21 nodes: 0.42 % at 38.0 µs a tick.",
                    "Cheapest under 5 %: rod, 11 nodes: 1.7 % at 17.0 µs a tick.",
                    "Most accurate within 1 ms a tick: rod, 81 nodes: 0.026 % at 640 µs a tick, but one tick in a hundred "
                    "takes longer than 1.30 ms."));
}

TEST(Verdict, SaysInOneSentenceWhatIsTheSame) {
    EXPECT_THAT(result_of(Timed::step, {{"a", 0.004, 38.0, 45.0}, {"b", 0.03, 50.0, 60.0}}).verdict,
                ElementsAre("Cheapest under 1 %, and under 5 %: rod, a: 0.40 % at 38.0 µs a step.",
                            "Most accurate within 1 ms a step: rod, a: 0.40 % at 38.0 µs a step."));
}

TEST(Verdict, SaysHowFarOffTheNearestIs) {
    EXPECT_THAT(result_of(Timed::tick, {{"a", 0.3, 1500.0, 1600.0}, {"b", 0.013, 2100.0, 2200.0}}).verdict,
                ElementsAre("None is under 1 %: the nearest is rod, b: 1.3 % at 2.10 ms a tick.",
                            "Cheapest under 5 %: rod, b: 1.3 % at 2.10 ms a tick.",
                            "None is within 1 ms a tick: the cheapest is rod, a: 30 % at 1.50 ms a tick."));
    EXPECT_EQ(result_of(Timed::tick, {{"a", 0.05, 1.0, 1.0}}).verdict.front(),
              "None is under 5 %: the nearest is rod, a: 5.0 % at 1.00 µs a tick.");
}

TEST(Verdict, HoldsALoadToNoTick) {
    EXPECT_EQ(result_of(Timed::load, {{"a", 0.004, 38e3, 45e3}}).verdict.back(),
              "Most accurate: rod, a: 0.40 % at 38.0 ms a load.");
    EXPECT_EQ(result_of(Timed::answer, {{"a", 0.004, 38.0, 45.0}}).verdict.back(),
              "Most accurate within 1 ms an answer: rod, a: 0.40 % at 38.0 µs an answer.");
}

TEST(Verdict, CountsWhereNothingIsTimed) {
    EXPECT_THAT(
        result_of(Timed::nothing, usual).verdict,
        ElementsAre("Under 1 %: 4 of 6, the coarsest of them rod, 21 nodes: 0.42 %.",
                    "Under 5 %: 5 of 6, the coarsest of them rod, 11 nodes: 1.7 %.", "Most accurate: rod, 161 nodes: 0.0060 %."));
    EXPECT_THAT(result_of(Timed::nothing, {{"a", 0.3, 0.0, 0.0}}).verdict,
                ElementsAre("None is under 5 %. Most accurate: rod, a: 30 %."));
    EXPECT_THAT(front_of(result_of(Timed::nothing, usual)), ElementsAre());
}

TEST(Verdict, LetsTheReferenceNotWinSilently) {
    std::vector<Point> points = usual;
    points.push_back({"321 nodes", 0.0, 5.0, 6.0});
    Result result = result_of(Timed::tick, points);
    result.settings.back().is_reference = true;
    add_verdict(result);
    EXPECT_EQ(result.verdict.front(), "Cheapest under 1 %: rod, 21 nodes: 0.42 % at 38.0 µs a tick.");
    EXPECT_EQ(result.verdict.back(), "rod, 321 nodes is the reference itself and takes no part here (it costs 5.00 µs a tick).");
    EXPECT_THAT(front_of(result), ElementsAre("6 nodes", "11 nodes", "21 nodes", "41 nodes", "81 nodes", "161 nodes"));
}

TEST(Verdict, SaysThatATimeIsDoubtful) {
    Result result = result_of(Timed::tick, {{"a", 0.004, 38.0, 45.0}});
    result.settings.front().timing->contended = true;
    add_verdict(result);
    EXPECT_EQ(result.verdict.back(), "Most accurate within 1 ms a tick: rod, a: 0.40 % at 38.0 µs a tick (on a busy machine).");
}

TEST(Verdict, OfNothingSaysSo) {
    EXPECT_THAT(result_of(Timed::tick, {{"a", infinity, 38.0, 45.0}}).verdict,
                ElementsAre("No setting has an error to compare."));
    EXPECT_THAT(result_of(Timed::nothing, {}).verdict, ElementsAre("No setting has an error to compare."));
    Result untimed = result_of(Timed::tick, {{"a", 0.01, 38.0, 45.0}});
    untimed.settings.front().timing.reset();
    add_verdict(untimed);
    EXPECT_THAT(untimed.verdict, ElementsAre("No setting has an error to compare."));
}

TEST(ParetoFront, IsWhatNoOtherBeatsInBoth) {
    EXPECT_THAT(front_of(result_of(Timed::tick, {{"slow", 0.02, 50.0, 50.0},
                                                 {"cheap", 0.10, 10.0, 10.0},
                                                 {"good", 0.01, 40.0, 40.0},
                                                 {"good too", 0.01, 40.0, 40.0},
                                                 {"as near, dearer", 0.01, 41.0, 41.0},
                                                 {"as cheap, further", 0.11, 10.0, 10.0},
                                                 {"failed", infinity, 1.0, 1.0}})),
                ElementsAre("cheap", "good", "good too"));
}

TEST(Verdict, ComparesNoSeriesWhereEachHasAReferenceOfItsOwn) {
    Result result = result_of(Timed::tick, {{"1 kHz", 0.002, 5.0, 6.0}});
    SettingResult other = result.settings.front();
    other.series = "rigid";
    other.error = {0.001, 0.001, 0.001, 0.001};
    other.timing->median = 1.0;
    result.settings.push_back(other);
    add_verdict(result);
    EXPECT_FALSE(result.settings.front().on_front) << "the other is cheaper and nearer";

    result.own_references = true;
    add_verdict(result);
    EXPECT_TRUE(result.settings.front().on_front);
    EXPECT_THAT(result.verdict, ElementsAre("Cheapest under 1 %, and under 5 %: rod, 1 kHz: 0.20 % at 5.00 µs a tick.",
                                            "Most accurate within 1 ms a tick: rod, 1 kHz: 0.20 % at 5.00 µs a tick.",
                                            "Cheapest under 1 %, and under 5 %: rigid, 1 kHz: 0.10 % at 1.00 µs a tick.",
                                            "Most accurate within 1 ms a tick: rigid, 1 kHz: 0.10 % at 1.00 µs a tick."));
}

}    // namespace
}    // namespace stylet::study
