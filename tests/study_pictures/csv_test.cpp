#include "apps/stylet/study_csv.h"
#include "tests/study_pictures/results.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

namespace stylet::study_pictures {
namespace {

using testing::Contains;
using testing::ElementsAre;

struct Csv {
    std::vector<std::string> comments;
    std::vector<std::string> header;
    std::vector<std::vector<std::string>> rows;

    [[nodiscard]] std::string cell(std::size_t row, const std::string& name) const {
        const auto column = std::ranges::find(header, name);
        return column == header.end() ? "no such column" : rows.at(row).at(static_cast<std::size_t>(column - header.begin()));
    }
    [[nodiscard]] double number(std::size_t row, const std::string& name) const { return std::stod(cell(row, name)); }
};

/// RFC 4180, of one line.
std::vector<std::string> cells_of(const std::string& line) {
    std::vector<std::string> cells{""};
    bool quoted = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (line[i] == '"' && quoted && i + 1 < line.size() && line[i + 1] == '"')
            cells.back() += line[++i];
        else if (line[i] == '"')
            quoted = !quoted;
        else if (line[i] == ',' && !quoted)
            cells.emplace_back();
        else
            cells.back() += line[i];
    }
    return cells;
}

Csv read(const std::string& text) {
    Csv csv;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("#"))
            csv.comments.push_back(line);
        else if (csv.header.empty())
            csv.header = cells_of(line);
        else
            csv.rows.push_back(cells_of(line));
    }
    return csv;
}

TEST(StudyCsv, GivesBackEveryNumber) {
    for (const study::Result& result : {many_settings(), split_errors(), odd_settings(), nothing_timed()}) {
        const Csv csv = read(app::study_csv(result));
        ASSERT_EQ(csv.rows.size(), result.settings.size());
        for (std::size_t i = 0; i < csv.rows.size(); ++i) {
            const study::SettingResult& setting = result.settings[i];
            ASSERT_EQ(csv.rows[i].size(), csv.header.size());
            EXPECT_EQ(csv.cell(i, "series"), setting.series);
            EXPECT_EQ(csv.cell(i, "setting"), setting.label);
            EXPECT_EQ(csv.number(i, "error [1]"), setting.error.judged);
            EXPECT_EQ(csv.number(i, "error p95 [1]"), setting.error.p95);
            EXPECT_EQ(csv.cell(i, "failed"), setting.failed() ? "1" : "0");
            EXPECT_EQ(csv.cell(i, "front"), setting.on_front ? "1" : "0");
            if (!setting.timing) {
                EXPECT_EQ(csv.cell(i, "median [us]"), "");
                continue;
            }
            EXPECT_EQ(csv.number(i, "median [us]"), setting.timing->median);
            EXPECT_EQ(csv.number(i, "p99 [us]"), setting.timing->p99);
            EXPECT_EQ(csv.number(i, "worst [us]"), setting.timing->worst);
            EXPECT_EQ(csv.cell(i, "contended"), setting.timing->contended ? "1" : "0");
        }
    }
}

TEST(StudyCsv, NamesTheSplitsPartsInItsHeader) {
    const study::Result result = split_errors();
    const Csv csv = read(app::study_csv(result));
    EXPECT_EQ(csv.number(0, "solver [1]"), result.settings[0].split_part->judged);
    EXPECT_EQ(csv.number(0, "discretisation [1]"), result.settings[0].split_rest->judged);
}

TEST(StudyCsv, BeginsWithWhatItIsAndHowToMakeItAgain) {
    const Csv csv = read(app::study_csv(many_settings()));
    ASSERT_FALSE(csv.comments.empty());
    EXPECT_EQ(csv.comments.front(), "# stylet study 1");
    EXPECT_THAT(csv.comments, Contains("# title: The whole insertion, Fig. 10(a)"));
    EXPECT_THAT(csv.comments, Contains("# machine: Example 3000, 2 processors, Linux 6.1; stylet 0.1.0, g++ 12.2.0, Release"));
    EXPECT_THAT(csv.comments, Contains("# command: stylet study scenes/studies/example.yaml --out out"));
}

TEST(StudyCsv, WordsDoNotBreakItsRows) {
    study::Result result = three_settings();
    result.title = "Two\nlines";
    result.settings[0].series = "a, \"b\"";
    result.settings[0].remarks = {"first, of two", "second"};
    const Csv csv = read(app::study_csv(result));
    ASSERT_EQ(csv.rows.size(), 3);
    EXPECT_EQ(csv.cell(0, "series"), "a, \"b\"");
    EXPECT_EQ(csv.cell(0, "remarks"), "first, of two; second");
    for (const std::vector<std::string>& row : csv.rows) EXPECT_EQ(row.size(), csv.header.size());
}

}    // namespace
}    // namespace stylet::study_pictures
