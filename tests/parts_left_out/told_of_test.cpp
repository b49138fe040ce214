// What `stylet run` says of scenes that leave parts out, and what it is silent about.
#include "tests/commands/command.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace stylet::commands {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

std::string validation(const std::string& name) {
    return (scene_folder / "validation" / (name + ".yaml")).string();
}

std::string summary_of(const std::string& name) {
    const Outcome run = Bench().stylet({"run", validation(name)});
    EXPECT_EQ(run.code, 0) << run.err;
    return run.out;
}

json json_of(const std::string& name) {
    const Outcome run = Bench().stylet({"run", validation(name), "--json", "-"});
    EXPECT_EQ(run.code, 0) << run.err;
    return json::parse(run.out);
}

void expect_silence(const std::string& summary, const std::vector<std::string>& words) {
    for (const std::string& word : words) EXPECT_THAT(summary, Not(HasSubstr(word)));
}

TEST(SummaryOfATissueAlone, TellsHowFarItsPatchMovedAndNothingOfANeedle) {
    const std::string summary = summary_of("half_space_patch");
    for (const char* line :
         {"no events", "patch of effects[0]   moved by (0.000, 0.000, -1.370) mm under (0.000, 0.000, -1.000) N",
          "load work     0.6849 mJ", "= stored      0.6849 mJ"}) {
        EXPECT_THAT(summary, HasSubstr(line));
    }
    expect_silence(summary,
                   {"buckled", "bow", "hand", "base", "fracture", "friction", "burst", "released", "puncture", "force chain"});
}

TEST(SummaryOfANeedleAlone, TellsWhenItBuckledAndNothingOfATissue) {
    const std::string loaded = summary_of("column_in_air_end_load");
    for (const char* line : {"peak base force   0.670 N", "buckled           at 0.643 N (critical load 0.642 N)",
                             "largest bow       37.87 mm", "load work", "= stored"}) {
        EXPECT_THAT(loaded, HasSubstr(line));
    }
    expect_silence(loaded, {"depth", "travel", "hand", "fracture", "friction", "burst", "released", "puncture", "patch"});

    const std::string pinned = summary_of("column_in_air_pinned");
    for (const char* line :
         {"peak hand force   0.649 N", "buckled           at 0.642 N", "largest bow       17.96 mm", "hand work"})
        EXPECT_THAT(pinned, HasSubstr(line));
    expect_silence(pinned, {"depth", "load work", "fracture", "friction", "burst", "released", "puncture", "patch"});
}

TEST(JsonOfATissueAlone, HoldsForceAndDisplacementOfEveryPatchAtEveryTick) {
    const json summary = json_of("half_space_patch_ramp");
    const json& loads = summary.at("loads");
    ASSERT_EQ(loads.at("patches").size(), 1u);
    const json& patch = loads.at("patches").at(0);
    EXPECT_EQ(patch.at("effect"), "effects[0]");
    EXPECT_EQ(patch.at("centre"), json({0.0, 0.0, 0.0}));
    EXPECT_EQ(patch.at("size"), json({0.021, 0.021, 0.0}));
    ASSERT_EQ(loads.at("times").size(), 600u);
    ASSERT_EQ(patch.at("force").size(), 600u);
    ASSERT_EQ(patch.at("displacement").size(), 600u);
    constexpr double rounding = 1e-12;       // of 1 N
    constexpr double sinks = -1.36985e-3;    // [m] by 1 N, see the scene
    constexpr double printed = 1e-8;         // [m] its digits
    for (const std::size_t tick : {0u, 249u, 499u, 599u}) {
        const double share = std::min(1.0, static_cast<double>(tick + 1) / 500.0);
        EXPECT_NEAR(loads.at("times").at(tick), 1e-3 * static_cast<double>(tick + 1), rounding);
        EXPECT_NEAR(patch.at("force").at(tick).at(2), -share, rounding);
        EXPECT_NEAR(patch.at("displacement").at(tick).at(2), share * sinks, printed);
    }
    EXPECT_TRUE(summary.at("peak_hand_force").is_null());
    EXPECT_TRUE(summary.at("largest_deflection").is_null());
    EXPECT_TRUE(summary.at("hand").is_null());
    EXPECT_EQ(summary.at("libraries").size(), 2u);
}

TEST(JsonOfANeedleAlone, HasNoLoadedPatches) {
    const json summary = json_of("column_in_air_end_load");
    EXPECT_TRUE(summary.at("loads").is_null());
    EXPECT_TRUE(summary.at("hand").is_null());
    EXPECT_GT(summary.at("ledger").at("load_work"), 0.0);
    EXPECT_EQ(summary.at("libraries").size(), 3u);
}

TEST(RecordingOfATissueAlone, HasNoColumnOfANeedle) {
    const Bench bench;
    ASSERT_EQ(bench.stylet({"run", validation("half_space_patch"), "--quiet"}).code, 0);
    const std::string recording = bench.read("out/half_space_patch.csv");
    EXPECT_THAT(recording, HasSubstr("\ntime [s],patch_displacement [m],load_work [J],stored [J],"));
    expect_silence(recording, {"hand_force", "deflection", "critical_load", "depth"});
}

TEST(RecordingOfANeedleAlone, HasNoColumnOfATissue) {
    const Bench bench;
    ASSERT_EQ(bench.stylet({"run", validation("column_in_air_end_load"), "--quiet"}).code, 0);
    const std::string recording = bench.read("out/column_in_air_end_load.csv");
    EXPECT_THAT(recording, HasSubstr("hand_force [N]"));
    expect_silence(recording, {"patch_displacement"});
}

}    // namespace
}    // namespace stylet::commands
