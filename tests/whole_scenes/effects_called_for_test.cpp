// Only what a scene calls for is in the process, and costs anything.
#include "tests/commands/command.h"
#include "tests/whole_scenes/mapped_plugins.h"
#include "tests/whole_scenes/trace.h"

#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

namespace stylet::whole_scenes {
namespace {

const core::Override flexible{"needle.type", "beam_column"};
const core::Override may_buckle{"needle.buckling", "{type: euler}"};
const core::Override short_stroke{"device.cycles", "1"};

TEST(Libraries, AreAllGoneOnceASceneIsRead) {
    for (const char* name : {"fig9", "fig10a_l150"}) (void)core::read_scene(paper_scene(name), {}, plugin_folders());
    EXPECT_EQ(mapped_plugins(), std::vector<std::string>{});
}

TEST(Libraries, AreThoseThatTheSceneNamesWhileItRunsAndNoneAfter) {
    {
        Stage stage(own_scene("stroke"), {flexible, short_stroke});
        (void)play(stage);
        EXPECT_EQ(mapped_plugins(),
                  (std::vector<std::string>{"beam_column", "fracture", "friction", "half_space", "recorded_hand"}));
    }
    EXPECT_EQ(mapped_plugins(), std::vector<std::string>{});
}

TEST(Libraries, IncludeTheBucklingLibraryWhereTheSceneAsksForIt) {
    Stage stage(own_scene("stroke"), {flexible, may_buckle, short_stroke});
    (void)play(stage);
    EXPECT_EQ(mapped_plugins(),
              (std::vector<std::string>{"beam_column", "euler", "fracture", "friction", "half_space", "recorded_hand"}));
}

std::vector<std::string> libraries_of_summary(const std::vector<std::string>& more) {
    const commands::Bench bench;
    std::vector<std::string> arguments{"run",   own_scene("stroke").string(), "--json", "-", "--set", "device.cycles=1",
                                       "--set", "needle.type=beam_column"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const commands::Outcome outcome = bench.stylet(arguments);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    std::vector<std::string> names;
    const nlohmann::json summary = nlohmann::json::parse(outcome.out);
    for (const auto& library : summary.at("libraries")) {
        names.push_back(std::filesystem::path(library.get<std::string>()).stem().string());
    }
    return names;
}

TEST(Summary, ListsABucklingLibraryOnlyWhereTheSceneAsksForIt) {
    EXPECT_EQ(std::ranges::count(libraries_of_summary({}), "euler"), 0);
    EXPECT_EQ(std::ranges::count(libraries_of_summary({"--set", "needle.buckling={type: euler}"}), "euler"), 1);
}

}    // namespace
}    // namespace stylet::whole_scenes
