#include "apps/stylet/markdown.h"
#include "apps/stylet/study_page.h"
#include "tests/study_pictures/results.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

namespace stylet::study_pictures {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

/// Cells of a table's line; an escaped bar is a bar.
std::size_t cells_in(const std::string& line) {
    std::size_t bars = 0;
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (line[i] == '|' && (i == 0 || line[i - 1] != '\\')) ++bars;
    }
    return bars - 1;
}

/// Of the first table's lines.
std::vector<std::size_t> row_widths(const std::string& page) {
    std::vector<std::size_t> widths;
    std::istringstream lines(page);
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("|"))
            widths.push_back(cells_in(line));
        else if (!widths.empty())
            break;
    }
    return widths;
}

TEST(Markdown, EscapesWhatWouldBeMarkupButNotCode) {
    EXPECT_EQ(app::markdown("a*b|c<d\\"), "a\\*b|c\\<d\\\\");
    EXPECT_EQ(app::markdown_cell("`a|b` c|d"), "`a\\|b` c\\|d") << "a bar would end the cell";
    EXPECT_EQ(app::markdown("`a*b` and c*d"), "`a*b` and c\\*d");
    EXPECT_EQ(app::markdown("a lone ` and c*d"), "a lone \\` and c\\*d");
    EXPECT_EQ(app::markdown("two\nlines"), "two lines");
    EXPECT_EQ(app::markdown("effects[1] and [a](b)"), "effects[1] and [a\\](b)");
    EXPECT_EQ(app::markdown("# of nodes"), "\\# of nodes");
    EXPECT_EQ(app::markdown("-1.95 of hand_force"), "-1.95 of hand_force");
}

TEST(StudyPage, SaysFirstThatItIsWritten) {
    EXPECT_THAT(app::study_page(three_settings(), "three.png"), StartsWith("<!-- Written by `stylet study`"));
}

TEST(StudyPage, HoldsQuestionPictureVerdictTableAndHowItWasMeasured) {
    const study::Result result = many_settings();
    const std::string page = app::study_page(result, "many.png");
    EXPECT_THAT(page, AllOf(HasSubstr("\n# The whole insertion, Fig. 10(a)\n"), HasSubstr(result.question),
                            HasSubstr("](many.png)\n"), HasSubstr("\n- " + result.verdict.front() + "\n"),
                            HasSubstr("| rod | 21 nodes | 0.52 % | 162 µs | 219 µs | 679 µs | ◆ |"),
                            HasSubstr("| rod | `needle.rod.nodes` | -1.95 | 6 |")));
    EXPECT_THAT(page, AllOf(HasSubstr("`paper/fig10a_l200.yaml`"), HasSubstr(result.measured), HasSubstr(result.reference),
                            HasSubstr("without the first 100 of a run"), HasSubstr("a tick, 5 repetitions, 1 thread"),
                            HasSubstr("Example 3000"), HasSubstr("g++ 12.2.0, Release")));
    EXPECT_TRUE(page.ends_with("```sh\n" + result.command + "\n```\n"));
}

TEST(StudyPage, NamesTheCasesAndTheReferencesTime) {
    EXPECT_THAT(app::study_page(split_errors(), "p.png"), HasSubstr("the error is the median of 20 loads"));
    EXPECT_THAT(app::study_page(odd_settings(), "p.png"), HasSubstr("The reference itself takes 172 µs a tick"));
    EXPECT_THAT(app::study_page(nothing_timed(), "p.png"), AllOf(Not(HasSubstr("Timed")), Not(HasSubstr("warm-up"))));
}

TEST(StudyPage, WordsDoNotBreakItsTable) {
    study::Result result = many_settings();
    result.settings[0].series = "a|b";
    result.settings[1].remarks = {"found *none*\nat all"};
    const std::vector<std::size_t> widths = row_widths(app::study_page(result, "many.png"));
    ASSERT_EQ(widths.size(), result.settings.size() + 2);
    for (const std::size_t width : widths) EXPECT_EQ(width, widths.front());
}

}    // namespace
}    // namespace stylet::study_pictures
