#include "tests/commands/command.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace stylet::commands {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

TEST(Check, EveryPreparedSceneIsSound) {
    const Bench bench;
    int scenes = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(scene_folder)) {
        if (entry.path().extension() != ".yaml") continue;
        const Outcome check = bench.stylet({"check", entry.path().string()});
        EXPECT_EQ(check.code, 0) << check.err;
        EXPECT_EQ(check.out, entry.path().string() + ": sound\n");
        ++scenes;
    }
    EXPECT_GE(scenes, 8);    // Figs. 9, 10(a) and 10(b) of the paper
}

TEST(Check, TellsAllErrorsOfAllScenesAndRunsNothing) {
    const Bench bench;
    bench.write("bad.yaml", "stylet: 1\ntitle: Bad\n");
    const Outcome check = bench.stylet({"check", "bad.yaml", paper("fig9"), "nowhere.yaml"});
    EXPECT_EQ(check.code, 2);
    EXPECT_EQ(check.out, paper("fig9") + ": sound\n");
    for (const char* word : {"bad.yaml", "tissue", "needle", "run", "nowhere.yaml"}) EXPECT_THAT(check.err, HasSubstr(word));
    EXPECT_FALSE(bench.has("out"));
}

TEST(Check, TakesOverrides) {
    const Bench bench;
    EXPECT_EQ(bench.stylet({"check", paper("fig9"), "--set", "needle.type=rigid"}).code, 0);
    const Outcome wrong = bench.stylet({"check", paper("fig9"), "--set", "needle.length=3 kg"});
    EXPECT_EQ(wrong.code, 2);
    EXPECT_THAT(wrong.err, HasSubstr("needle.length"));
    EXPECT_THAT(wrong.out, IsEmpty());
}

TEST(Check, BinaryRubbishIsASentenceAndNoCrash) {
    const Bench bench;
    bench.write("rubbish.yaml", std::string("\x00\xff\xfe\x01{[&*!%@`\t\r\n", 16));
    const Outcome check = bench.stylet({"check", "rubbish.yaml"});
    EXPECT_EQ(check.code, 2);
    EXPECT_THAT(check.err, HasSubstr("rubbish.yaml"));
}

TEST(Check, BinaryRubbishAsARecordedHandIsAShortSentenceThatLeavesTheTerminalAlone) {
    const Bench bench;
    std::filesystem::copy_file(paper("fig9"), bench.path("scene.yaml"));
    bench.write("rubbish.csv", "\x1b[2J" + std::string(1000, 'x') + "\n");
    const Outcome check = bench.stylet({"check", "scene.yaml", "--set", "device={type: recorded_hand, file: rubbish.csv}"});
    EXPECT_EQ(check.code, 2);
    EXPECT_THAT(check.err, HasSubstr("line 1: found \"\\x1b[2Jxxxx"));
    EXPECT_LT(check.err.size(), 300u) << check.err;
}

}    // namespace
}    // namespace stylet::commands
