#include "apps/stylet/study_text.h"
#include "tests/study_pictures/results.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

namespace stylet::study_pictures {
namespace {

using testing::AllOf;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;

/// The line that begins with this; empty where there is none.
std::string line_of(const std::string& text, const std::string& beginning) {
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("  " + beginning)) return line;
    }
    return "";
}

TEST(StudyText, HasARowForEachSetting) {
    const study::Result result = many_settings();
    const std::string text = app::study_text(result);
    for (const study::SettingResult& setting : result.settings)
        EXPECT_THAT(text, ContainsRegex(setting.series + " +" + setting.label)) << setting.name();
    EXPECT_THAT(line_of(text, "rod                              21 nodes"),
                AllOf(HasSubstr("0.52 %"), HasSubstr("162 µs"), HasSubstr("219 µs"), HasSubstr("679 µs"), HasSubstr("◆")));
}

TEST(StudyText, MarksWhatFailedAndWhatHadToWait) {
    const std::string text = app::study_text(many_settings());
    EXPECT_THAT(line_of(text, "beam_column                      250 Hz"),
                AllOf(HasSubstr(" none "), HasSubstr("never punctured")));
    EXPECT_THAT(line_of(text, "beam_column                      500 Hz"), HasSubstr("† 38.2 µs"));
    EXPECT_THAT(line_of(text, "†"), HasSubstr("the machine had other work"));
    EXPECT_THAT(app::study_text(three_settings()), Not(HasSubstr("†")));
}

TEST(StudyText, TellsOrdersMachineAndVerdict) {
    const study::Result result = many_settings();
    const std::string text = app::study_text(result);
    EXPECT_THAT(text, HasSubstr("rod: error ~ needle.rod.nodes^-1.95 (6 points above 1.0e-4 %)"));
    EXPECT_THAT(text, HasSubstr("Example 3000, 2 processors, Linux 6.1; stylet 0.1.0, g++ 12.2.0, Release"));
    EXPECT_THAT(text, HasSubstr("a tick, 5 repetitions, 1 thread\n"));
    EXPECT_TRUE(text.ends_with("  " + result.verdict.back() + "\n")) << text;
}

TEST(StudyText, SplitErrorsAndCasesHaveColumns) {
    const std::string text = app::study_text(split_errors());
    EXPECT_THAT(text, ContainsRegex("error +solver +discretisation +p95 +worst +median +p99 +worst"));
    EXPECT_THAT(line_of(text, "quasi_newton to 0.01     32 cells"),
                AllOf(HasSubstr("0.95 %     0.40 %           0.86 %   2.0 %   3.2 %")));
    EXPECT_THAT(app::study_text(three_settings()), AllOf(Not(HasSubstr("p95")), Not(HasSubstr("cases"))));
}

TEST(StudyText, TimesAreComparedWithATimedReference) {
    EXPECT_THAT(line_of(app::study_text(odd_settings()), "rigid"), AllOf(HasSubstr("< 1e-12 %"), HasSubstr("29 ×")));
    EXPECT_THAT(app::study_text(three_settings()), Not(HasSubstr("speed-up")));
}

TEST(StudyText, TheFrontIsItsSeriesWhereEachHasItsOwnReference) {
    study::Result result = many_settings();
    EXPECT_THAT(app::study_text(result), HasSubstr("◆ on the Pareto front"));
    result.own_references = true;
    EXPECT_THAT(app::study_text(result), HasSubstr("◆ on its series' Pareto front"));
}

TEST(StudyText, WhereNothingIsTimedThereAreNoTimes) {
    const std::string text = app::study_text(nothing_timed());
    EXPECT_THAT(text, AllOf(Not(HasSubstr("µs")), Not(HasSubstr("p99")), Not(HasSubstr("timed"))));
    EXPECT_THAT(text, HasSubstr("median of 200 cases"));
}

TEST(StudyText, SaysThatItWasStopped) {
    study::Result result = three_settings();
    result.stopped = true;
    EXPECT_THAT(app::study_text(result), HasSubstr("Stopped before all was run"));
}

}    // namespace
}    // namespace stylet::study_pictures
