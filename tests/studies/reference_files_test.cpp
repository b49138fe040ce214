#include "apps/study/reference_files.h"

#include "apps/study/recording_file.h"

#include <stylet/error.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <unistd.h>

#include <filesystem>
#include <fstream>

namespace stylet::study {
namespace {

using testing::ElementsAre;
using testing::Pair;
using testing::UnorderedElementsAre;

const CurveMeasure force_over_travel{.column = "hand_force", .over = "travel"};
const TableForm loads{.unit = "N"};

/// A file of one test's own; errors name it known.csv.
class ReferenceFiles : public testing::Test {
protected:
    ReferenceFiles() : folder_(std::filesystem::path(testing::TempDir()) / ("stylet_references_" + std::to_string(getpid()))) {
        std::filesystem::create_directories(folder_);
    }
    ~ReferenceFiles() override { std::filesystem::remove_all(folder_); }

    [[nodiscard]] std::filesystem::path file() const { return folder_ / "known.csv"; }
    void write(const std::string& text) const { std::ofstream(file(), std::ios::binary) << text; }

    [[nodiscard]] Outcome curve(const std::string& text) const {
        write(text);
        return curve_file(file(), force_over_travel);
    }
    [[nodiscard]] std::map<std::string, double> table(const std::string& text, const TableForm& form = loads) const {
        write(text);
        return table_file(file(), form);
    }

    /// What `read` of this text is refused with, without the folder.
    template <class Read>
    [[nodiscard]] std::string refusal(const std::string& text, const Read& read) const {
        try {
            (void)read(text);
        } catch (const Error& error) {
            const std::string sentence = error.what(), folder = folder_.string() + "/";
            return sentence.starts_with(folder) ? sentence.substr(folder.size()) : sentence;
        }
        return "accepted";
    }
    [[nodiscard]] std::string curve_refusal(const std::string& text) const {
        return refusal(text, [this](const std::string& t) { return curve(t); });
    }
    [[nodiscard]] std::string table_refusal(const std::string& text, const TableForm& form = loads) const {
        return refusal(text, [&](const std::string& t) { return table(t, form); });
    }

private:
    std::filesystem::path folder_;
};

TEST_F(ReferenceFiles, HoldACurveInAnyUnitsAmongOtherColumns) {
    const Outcome found =
        curve("# read off a picture\r\n\r\nnote,hand_force [mN],travel [mm]\r\nfirst,250,1\r\n# a word\r\n,500,2");
    EXPECT_THAT(found.x, ElementsAre(1e-3, 2e-3));
    EXPECT_THAT(found.y, ElementsAre(0.25, 0.5));
    EXPECT_EQ(found.missing, "");
}

TEST_F(ReferenceFiles, HoldACurveAsARecordingWroteIt) {
    const Outcome found = curve(
        "# stylet recording 1\n# title: a run\ntime [s],travel [m],hand_force "
        "[N],event\n0,0,0,\n0.1,0.001,0.25,punctured\n0.2,0.002,0.5,"
        "\n0.3,0.00");
    EXPECT_THAT(found.x, ElementsAre(0.0, 0.001, 0.002)) << "without the row that a killed run cut off";
    EXPECT_THAT(found.y, ElementsAre(0.0, 0.25, 0.5));
    EXPECT_THAT(curve("# stylet recording 1\ntravel [mm],hand_force [mN],event\n1,250,\n").y, ElementsAre(0.25)) << "in SI";
    EXPECT_EQ(curve_refusal("# stylet recording 1\ntravel [s],hand_force [N],event\n1,2,\n"),
              "known.csv: found 'travel [s]', wanted a unit of travel, such as 'travel [m]'");
    write("# stylet recording 1\ntime [s],event\n0,\n");
    EXPECT_THROW((void)curve_file(file(), force_over_travel), Error);
    EXPECT_TRUE(is_recording(file()));
    write("# a curve\n");
    EXPECT_FALSE(is_recording(file()));
}

TEST_F(ReferenceFiles, SayWhatIsWrongWithACurve) {
    EXPECT_EQ(curve_refusal(""), "known.csv:1: found '', wanted a header with 'travel [m]'");
    EXPECT_EQ(curve_refusal("travl [m],hand_force [N]\n"),
              "known.csv:1: found 'travl [m],hand_force [N]', wanted a header with 'travel [m]'");
    EXPECT_EQ(curve_refusal("# x\ntravel [m],hand_force [mm]\n"),
              "known.csv:2: found 'hand_force [mm]', wanted a unit of hand_force, such as 'hand_force [N]'");
    EXPECT_EQ(curve_refusal("travel,hand_force [N]\n"),
              "known.csv:1: found 'travel', wanted a unit of travel, such as 'travel [m]'");
    EXPECT_EQ(curve_refusal("travel [m],hand_force [N]\n0,0\n1\n"),
              "known.csv:3: found '1', wanted a number for hand_force in place 2");
    EXPECT_EQ(curve_refusal("travel [m],hand_force [N]\n0,1 N\n"),
              "known.csv:2: found '0,1 N', wanted a number for hand_force in place 2");
    EXPECT_EQ(curve_refusal("travel [m],hand_force [N]\n0,inf\n"),
              "known.csv:2: found '0,inf', wanted a number for hand_force in place 2");
    EXPECT_EQ(curve_refusal("travel [m],hand_force [N]\n"),
              "known.csv:1: found no row after the header, wanted a CSV with travel and hand_force");
    std::filesystem::remove(file());
    EXPECT_THROW((void)curve_file(file(), force_over_travel), Error);
}

TEST_F(ReferenceFiles, HoldAValueOfEachCase) {
    EXPECT_THAT(table("# known\ncase,load [mN]\nrow1,7\nrow2,-9.5\n"),
                UnorderedElementsAre(Pair("row1", 7e-3), Pair("row2", -9.5e-3)));
    EXPECT_THAT(table("\xEF\xBB\xBFshape,ratio\r\nsquare,0.5\r\n", {.unit = "1"}), UnorderedElementsAre(Pair("square", 0.5)));
    const std::map<std::string, double> paper = table_file(std::filesystem::path(SCENE_FOLDER) / "paper" / "tables.csv", loads);
    EXPECT_EQ(paper.size(), 10U);
    EXPECT_EQ(paper.at("table1_row2"), 9.001);
}

TEST_F(ReferenceFiles, SayWhatIsWrongWithATable) {
    EXPECT_EQ(table_refusal(""), "known.csv:1: found '', wanted a header such as 'case,value [N]'");
    EXPECT_EQ(table_refusal("case,load [mm]\n"), "known.csv:1: found 'case,load [mm]', wanted a header such as 'case,value [N]'");
    EXPECT_EQ(table_refusal("case,load\n"), "known.csv:1: found 'case,load', wanted a header such as 'case,value [N]'");
    EXPECT_EQ(table_refusal("case,a [N],b [N]\n"),
              "known.csv:1: found 'case,a [N],b [N]', wanted a header such as 'case,value [N]'");
    EXPECT_EQ(table_refusal("case,load [N]\n", {.unit = "1"}),
              "known.csv:1: found 'case,load [N]', wanted a header such as 'case,value'");
    EXPECT_EQ(table_refusal("case,load [N]\na,b\n"),
              "known.csv:2: found 'a,b', wanted a case's name and its load in N, such as fig3,0.314");
    EXPECT_EQ(table_refusal("case,load [N]\n,1\n"),
              "known.csv:2: found ',1', wanted a case's name and its load in N, such as fig3,0.314");
    EXPECT_EQ(table_refusal("case,load [N]\na,1\na,2\n"), "known.csv:3: found 'a,2', wanted each case once");
    const TableForm scene_loads{.unit = "N", .of = "scene", .quantity = "load", .above_zero = true};
    EXPECT_EQ(table_refusal("case,load [N]\n", scene_loads),
              "known.csv:1: found 'case,load [N]', wanted the header 'scene,load [N]'");
    EXPECT_EQ(table_refusal("scene,load [N]\na,0\n", scene_loads),
              "known.csv:2: found 'a,0', wanted a scene's name and its load in N, such as fig3,0.314");
}

TEST(UnitOf, IsThatOfWhatIsMeasured) {
    EXPECT_EQ(unit_of(CurveMeasure{.column = "hand_force", .over = "travel"}), "N");
    EXPECT_EQ(unit_of(ValueMeasure{"peak_hand_force"}), "N");
    EXPECT_EQ(unit_of(ValueMeasure{"largest_deflection"}), "m");
    EXPECT_EQ(unit_of(ValueMeasure{"stored"}), "J");
    EXPECT_EQ(unit_of(EventMeasure{.event = "punctured", .column = "depth"}), "m");
    EXPECT_EQ(unit_of(AnswerMeasure{.depth = 0.0}), "N");
}

}    // namespace
}    // namespace stylet::study
