#include "tests/commands/command.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace stylet::commands {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

/// A needle alone in air, ten ticks long.
constexpr const char* alone = R"(stylet: 1
title: Alone
needle: {type: rigid, length: 100 mm, radius: 0.3 mm, youngs_modulus: 200 GPa, ends: clamped-free}
run: {rate: 1 kHz, duration: 10 ms}
)";

std::vector<std::string> run_alone(const std::vector<std::string>& more) {
    std::vector<std::string> arguments{"run", "alone.yaml"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
}

TEST(Series, AreOnlyOfWhatTheSceneHasAndAreNamedInTheSummary) {
    const Bench bench;
    bench.write("alone.yaml", alone);
    const Outcome run = bench.stylet(run_alone({"--vtu", "new/pictures", "--vtu-rate", "500 Hz"}));
    EXPECT_EQ(run.code, 0) << run.err;
    EXPECT_THAT(run.out, HasSubstr("series      new/pictures/alone_needle.pvd (6 moments, 0.002 s apart)\n"));
    EXPECT_TRUE(bench.has("new/pictures/alone_needle.pvd"));
    EXPECT_TRUE(bench.has("new/pictures/alone_needle_0005.vtu"));
    EXPECT_FALSE(bench.has("new/pictures/alone_needle_0006.vtu"));
    EXPECT_FALSE(bench.has("new/pictures/alone_tissue.pvd"));
    EXPECT_FALSE(bench.has("new/pictures/alone_contacts.pvd"));
}

TEST(Series, OfTissueAndNeedleTakeOneLineOfTheSummary) {
    const Bench bench;
    const Outcome run = bench.stylet({"run", paper("fig9"), "--vtu", "pictures", "--vtu-rate", "0.5 Hz"});
    EXPECT_EQ(run.code, 0) << run.err;
    EXPECT_THAT(run.out,
                HasSubstr("series      pictures/fig9_tissue.pvd, …_needle.pvd, …_contacts.pvd (5 moments, 2 s apart)\n"));
}

TEST(Series, AreNotWrittenUnlessAskedFor) {
    const Bench bench;
    bench.write("alone.yaml", alone);
    const Outcome run = bench.stylet(run_alone({}));
    EXPECT_EQ(run.code, 0) << run.err;
    EXPECT_THAT(run.out, Not(HasSubstr("series")));
    EXPECT_FALSE(bench.has("alone_needle.pvd"));
}

TEST(Series, TakeTheNearestNumberOfWholeTicks) {
    const Bench bench;
    bench.write("alone.yaml", alone);
    EXPECT_THAT(bench.stylet(run_alone({"--vtu", ".", "--vtu-rate", "300 Hz"})).out, HasSubstr("(4 moments, 0.003 s apart)"));
    EXPECT_THAT(bench.stylet(run_alone({"--vtu", ".", "--vtu-rate", "9 kHz"})).out, HasSubstr("(11 moments, 0.001 s apart)"));
    EXPECT_THAT(bench.stylet(run_alone({"--vtu", "."})).out, HasSubstr("(1 moment, 0.04 s apart)"));
    EXPECT_THAT(bench.stylet(run_alone({"--vtu", ".", "--vtu-rate", "1e-300 Hz"})).out, HasSubstr("(1 moment, "));
}

TEST(Series, RefuseARateThatIsNone) {
    const Bench bench;
    bench.write("alone.yaml", alone);
    const auto refusal = [&](const std::string& rate) {
        const Outcome run = bench.stylet(run_alone({"--vtu", "pictures", "--vtu-rate", rate}));
        EXPECT_EQ(run.code, 3) << rate;
        return run.err;
    };
    const std::string wanted = ", wanted a frequency in Hz such as '1 kHz', above 0\n";
    EXPECT_EQ(refusal("25"), "--vtu-rate: found '25' without a unit" + wanted);
    EXPECT_EQ(refusal("0 Hz"), "--vtu-rate: found '0 Hz'" + wanted);
    EXPECT_EQ(refusal("-3 Hz"), "--vtu-rate: found '-3 Hz'" + wanted);
    EXPECT_EQ(refusal("3 mm"), "--vtu-rate: found '3 mm'" + wanted);
    EXPECT_EQ(refusal("often"), "--vtu-rate: found 'often'" + wanted);
    EXPECT_FALSE(bench.has("pictures"));
}

TEST(Series, WantAFolderBeforeARate) {
    const Bench bench;
    bench.write("alone.yaml", alone);
    const Outcome run = bench.stylet(run_alone({"--vtu-rate", "25 Hz"}));
    EXPECT_EQ(run.code, 3);
    EXPECT_THAT(run.err, HasSubstr("--vtu-rate requires --vtu"));
}

TEST(Series, InAFolderThatCannotBeMadeAreOneSentence) {
    const Bench bench;
    bench.write("alone.yaml", alone);
    bench.write("taken", "a file");
    const Outcome run = bench.stylet(run_alone({"--vtu", "taken"}));
    EXPECT_EQ(run.code, 4);
    EXPECT_EQ(run.err, "taken: cannot be made a folder: Not a directory\n");
    EXPECT_THAT(run.out, IsEmpty());
}

TEST(Series, ThatCannotBeWrittenAreOneSentence) {
    const Bench bench;
    bench.write("alone.yaml", alone);
    std::filesystem::create_directories(bench.path("pictures/alone_needle.pvd"));
    const Outcome taken = bench.stylet(run_alone({"--vtu", "pictures"}));
    EXPECT_EQ(taken.code, 4);
    EXPECT_EQ(taken.err, "pictures/alone_needle.pvd: cannot be written: Is a directory\n");

    std::filesystem::create_directories(bench.path("full"));
    std::filesystem::create_symlink("/dev/full", bench.path("full/alone_needle_0000.vtu"));
    const Outcome full = bench.stylet(run_alone({"--vtu", "full"}));
    EXPECT_EQ(full.code, 4);
    EXPECT_EQ(full.err, "full/alone_needle_0000.vtu: cannot be written: No space left on device\n");
}

}    // namespace
}    // namespace stylet::commands
