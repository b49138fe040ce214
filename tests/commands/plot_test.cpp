#include "tests/commands/command.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

namespace stylet::commands {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

// Pictures with axes, labels and curves; an empty canvas stays well below.
constexpr std::size_t least_svg = 8000, least_png = 8000;    // [bytes]

constexpr const char* heading = "# stylet recording 1\n# title: ";
constexpr const char* columns = "time [s],travel [m],depth [m],hand_force [N],critical_load [N],event\n";

/// A push, a puncture at `rupture` [N], a slide.
std::string recording(const std::string& title, double rupture) {
    std::ostringstream text;
    text << heading << title << "\n# scene: synthetic.yaml\n# hash: 0\n" << columns;
    bool punctured = false;
    for (int tick = 0; tick <= 400; ++tick) {
        const double time = tick / 50.0, travel = 0.01 * time, depth = travel - 0.002;
        const double push = depth > 0.0 ? 20.0 * depth : 0.0;
        const bool now = !punctured && push >= rupture;
        punctured = punctured || now;
        text << time << ',' << travel << ',' << depth << ',' << (punctured ? 0.3 + 5.0 * depth : push) << ",inf,"
             << (now ? "punctured; first layer" : "") << '\n';
    }
    return text.str();
}

std::string small_recording(const std::string& rows) {
    return heading + std::string("Small\n") + columns + rows;
}

TEST(Plot, DrawsSvgAndPngBesideTheRecording) {
    const Bench bench;
    bench.write("one.csv", recording("One needle", 0.7));
    const Outcome plot = bench.stylet({"plot", "one.csv"});
    EXPECT_EQ(plot.code, 0) << plot.err;
    EXPECT_EQ(plot.out, "one.svg\none.png\n");
    const std::string svg = bench.read("one.svg"), png = bench.read("one.png");
    EXPECT_GT(svg.size(), least_svg);
    EXPECT_GT(png.size(), least_png);
    EXPECT_THAT(png, StartsWith("\x89PNG"));
    for (const char* text : {"One needle", "Tip depth (mm)", "Hand force (N)", "punctured, first layer"})
        EXPECT_THAT(svg, HasSubstr(text));
}

TEST(Plot, DrawsHowATissueAloneMovesInTime) {
    const Bench bench;
    bench.write("block.csv", heading + std::string("A block\ntime [s],patch_displacement [m],residual [J],event\n"
                                                   "0.001,0.0002,0,\n0.002,0.0004,0,\n0.003,0.0005,0,\n"));
    const Outcome plot = bench.stylet({"plot", "block.csv"});
    EXPECT_EQ(plot.code, 0) << plot.err;
    const std::string svg = bench.read("block.svg");
    for (const char* text : {"A block", "Time (s)", "Patch displacement (mm)"}) EXPECT_THAT(svg, HasSubstr(text));
}

TEST(Plot, PutsSeveralRecordingsIntoOnePictureWithALegendOfWhatDiffers) {
    const Bench bench;
    bench.write("a.csv", recording("Fig. 1: L = 150 mm", 0.7));
    bench.write("b.csv", recording("Fig. 1: L = 200 mm", 0.5));
    const Outcome plot = bench.stylet({"plot", "a.csv", "b.csv", "--x", "travel", "--out", "pictures/both"});
    EXPECT_EQ(plot.code, 0) << plot.err;
    EXPECT_TRUE(bench.has("pictures/both.png"));
    const std::string svg = bench.read("pictures/both.svg");
    EXPECT_THAT(svg, AllOf(HasSubstr(">L = 150 mm<"), HasSubstr(">L = 200 mm<"), HasSubstr("Hand travel (mm)"),
                           Not(HasSubstr("Fig. 1"))));
}

TEST(Plot, ATitleIsDrawnAsItStands) {
    const Bench bench;
    bench.write("one.csv", recording("One", 0.7));
    const Outcome plot =
        bench.stylet({"plot", "one.csv", "--title", "It's `touch ran` \"$HOME\" @x {/*2 y}_z^2", "--out", "odd'; touch ran"});
    EXPECT_EQ(plot.code, 0) << plot.err;
    EXPECT_FALSE(bench.has("ran"));
    EXPECT_THAT(bench.read("odd'; touch ran.svg"), HasSubstr("`touch ran`"));
    EXPECT_THAT(bench.read("odd'; touch ran.svg"), HasSubstr("{/*2 y}_z^2"));
}

TEST(Plot, AnyColumnCanBeAnAxis) {
    const Bench bench;
    bench.write("one.csv", recording("One", 0.7));
    EXPECT_EQ(bench.stylet({"plot", "one.csv", "--x", "time", "--y", "travel"}).code, 0);
    EXPECT_THAT(bench.read("one.svg"), AllOf(HasSubstr("Time (s)"), HasSubstr("Hand travel (mm)")));
}

TEST(Plot, AColumnThatIsNotThereIsToldWithThoseThatAre) {
    const Bench bench;
    bench.write("one.csv", recording("One", 0.7));
    const Outcome plot = bench.stylet({"plot", "one.csv", "--y", "force"});
    EXPECT_EQ(plot.code, 2);
    EXPECT_EQ(plot.err, "one.csv: found no column \"force\", wanted one of: time, travel, depth, hand_force, critical_load\n");
}

TEST(Plot, AColumnWithoutAFiniteNumberIsToldOf) {
    const Bench bench;
    bench.write("one.csv", recording("One", 0.7));
    const Outcome plot = bench.stylet({"plot", "one.csv", "--y", "critical_load"});
    EXPECT_EQ(plot.code, 2);
    EXPECT_EQ(plot.err, "one.csv: found no row where both depth and critical_load are finite\n");
}

TEST(Plot, IgnoresALineThatAKilledRunCutOff) {
    const Bench bench;
    bench.write("cut.csv", recording("Cut", 0.7) + "8.02,0.08");
    const Outcome plot = bench.stylet({"plot", "cut.csv"});
    EXPECT_EQ(plot.code, 0) << plot.err;
    EXPECT_TRUE(bench.has("cut.png"));
}

TEST(Plot, ARunInTheMiddleOfItsHeaderHoldsNothingToDraw) {
    const Bench bench;
    const std::string whole = recording("Cut", 0.7);
    for (std::size_t length = 0; length < whole.find("\n0,") + 4; length += 7) {
        bench.write("cut.csv", whole.substr(0, length));
        const Outcome plot = bench.stylet({"plot", "cut.csv"});
        EXPECT_EQ(plot.code, 2) << length;
        EXPECT_THAT(plot.err, StartsWith("cut.csv:")) << length;
    }
}

TEST(Plot, WrongRecordingsAreSentences) {
    struct Wrong {
        std::string text;
        const char* message;
    };
    const Wrong wrongs[] = {
        {"", "wrong.csv:1: found nothing, wanted \"# stylet recording 1\"\n"},
        {"time,force\n1,2\n",
         "wrong.csv:1: found \"time,force\", wanted \"# stylet recording 1\": this is no recording, or one of another version\n"},
        {"# stylet recording 2\n",
         "wrong.csv:1: found \"# stylet recording 2\", wanted \"# stylet recording 1\": this is no recording, or one of another "
         "version\n"},
        {"# stylet recording 1\ntime [s],depth [m]\n0,0\n",
         "wrong.csv:2: found the header \"time [s],depth [m]\", wanted columns that end in \"event\"\n"},
        {"# stylet recording 1\n,event\n0,\n",
         "wrong.csv:2: found the header \",event\", wanted columns that end in \"event\"\n"},
        {"# stylet recording 1\n\x1b[2J\n", "wrong.csv:2: found the header \"\\x1b[2J\", wanted columns that end in \"event\"\n"},
        {small_recording(""), "wrong.csv:3: the recording holds no whole row\n"},
        {small_recording("0,0,0,0,1,\n0,0,0\n0,0,0,0,1,\n"),
         "wrong.csv:5: the row ends before its hand_force, wanted 5 numbers\n"},
        {small_recording("0,0,zero,0,1,\n"), "wrong.csv:4: depth: found \"zero\", wanted a number\n"},
        {small_recording("0,0,,0,1,\n"), "wrong.csv:4: depth: found \"\", wanted a number\n"},
    };
    const Bench bench;
    for (const Wrong& wrong : wrongs) {
        bench.write("wrong.csv", wrong.text);
        const Outcome plot = bench.stylet({"plot", "wrong.csv"});
        EXPECT_EQ(plot.code, 2);
        EXPECT_EQ(plot.err, wrong.message);
    }
}

TEST(Plot, ARecordingThatIsNotThereIsNamed) {
    const Bench bench;
    const Outcome plot = bench.stylet({"plot", "nowhere.csv"});
    EXPECT_EQ(plot.code, 2);
    EXPECT_EQ(plot.err, "nowhere.csv: cannot be read: No such file or directory\n");
    std::filesystem::create_directory(bench.path("folder"));
    EXPECT_EQ(bench.stylet({"plot", "folder"}).err, "folder: found a folder, wanted a recording\n");
}

TEST(Plot, WithoutGnuplotSaysWhatToInstall) {
    const Bench bench;
    bench.write("one.csv", recording("One", 0.7));
    const Outcome plot = bench.stylet_with_path(bench.path("").string(), {"plot", "one.csv"});
    EXPECT_EQ(plot.code, 4);
    EXPECT_EQ(plot.err, "stylet: found no gnuplot on the PATH, wanted one to draw with (apt-get install gnuplot-nox)\n");
    EXPECT_FALSE(bench.has("one.svg"));
}

TEST(Plot, APlaceThatCannotBeWrittenIsToldOf) {
    const Bench bench;
    bench.write("one.csv", recording("One", 0.7));
    const Outcome plot = bench.stylet({"plot", "one.csv", "--out", "one.csv/picture"});
    EXPECT_EQ(plot.code, 4);
    EXPECT_THAT(plot.err, StartsWith("one.csv"));
}

TEST(Plot, DrawsWhatARunRecorded) {
    const Bench bench;
    ASSERT_EQ(bench.stylet({"run", paper("fig10a_l150"), paper("fig10a_l200"), "--quiet"}).code, 0);
    const Outcome plot = bench.stylet({"plot", "out/fig10a_l150.csv", "out/fig10a_l200.csv"});
    EXPECT_EQ(plot.code, 0) << plot.err;
    EXPECT_THAT(bench.read("out/fig10a_l150.svg"), AllOf(HasSubstr("punctured"), HasSubstr("buckled")));
}

}    // namespace
}    // namespace stylet::commands
