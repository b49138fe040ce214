// The commands that list: plugins and scenes.
#include "tests/commands/command.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <sstream>

namespace stylet::commands {
namespace {

using nlohmann::json;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

TEST(Plugins, AreListedWithTheirRole) {
    const Outcome list = Bench().stylet({"plugins"});
    EXPECT_EQ(list.code, 0);
    EXPECT_THAT(list.err, IsEmpty());
    for (const char* line : {"tissue +half_space +[A-Z]", "needle +beam_column +", "needle +rigid +", "buckling.* +euler +",
                             "effect +fracture +", "effect +friction +", "device +recorded_hand +"}) {
        EXPECT_THAT(list.out, ContainsRegex(line));
    }
}

TEST(Plugins, ShowOnesParametersWithUnitRangeAndMeaning) {
    const Outcome friction = Bench().stylet({"plugins", "friction"});
    EXPECT_EQ(friction.code, 0) << friction.err;
    EXPECT_THAT(friction.out, ContainsRegex("per_length +number \\(N/m\\) +≥ 0 +required\n +[a-z]"));
}

TEST(Plugins, ShowOnesFormulaSourceAndValidityInLinesThatFitAPage) {
    const Outcome friction = Bench().stylet({"plugins", "friction"});
    EXPECT_THAT(friction.out,
                ContainsRegex("\nformula:\n    .+\nsource:\n    Okamura.+\nvalidity:\n    [A-Z].+\nlibrary:\n    /"));
    std::istringstream lines(friction.out);
    constexpr std::size_t page = 120;    // [bytes] 110 characters and some of more than a byte
    for (std::string line; std::getline(lines, line);) {
        const bool path = line.ends_with("friction.so");
        EXPECT_TRUE(path || line.size() <= page) << line;
    }
}

TEST(Plugins, ShowTheFieldsOfRecordsFurtherIn) {
    const Outcome hand = Bench().stylet({"plugins", "recorded_hand"});
    EXPECT_THAT(hand.out, ContainsRegex("\n  motion +list of maps"));
    EXPECT_THAT(hand.out, ContainsRegex("\n      insert +number \\(m\\)"));
}

TEST(Plugins, AreDescribedAsJsonToo) {
    const Bench bench;
    const json all = json::parse(bench.stylet({"plugins", "--json"}).out);
    EXPECT_GE(all.size(), 7U);
    const json hand = json::parse(bench.stylet({"plugins", "recorded_hand", "--json"}).out);
    EXPECT_EQ(hand["role"], "device");
    for (const char* text : {"summary", "formula", "source", "validity"})
        EXPECT_FALSE(hand[text].get<std::string>().empty()) << text;
    const auto motion = std::find_if(hand["parameters"].begin(), hand["parameters"].end(),
                                     [](const json& parameter) { return parameter["name"] == "motion"; });
    ASSERT_NE(motion, hand["parameters"].end());
    EXPECT_EQ((*motion)["kind"], "list of maps");
    EXPECT_FALSE((*motion)["fields"].empty());
}

TEST(Plugins, SayWhichWayAParameterBuysAccuracy) {
    const Bench bench;
    EXPECT_THAT(bench.stylet({"plugins", "rod"}).out, ContainsRegex("evenly spaced; larger\\s+is\\s+finer\n"));
    EXPECT_THAT(bench.stylet({"plugins", "corotational_fem"}).out, ContainsRegex("fast; earlier\\s+words\\s+are\\s+finer\n"));
    const json rod = json::parse(bench.stylet({"plugins", "rod", "--json"}).out);
    for (const json& parameter : rod["parameters"]) {
        EXPECT_EQ(parameter.value("finer", "neither"), parameter["name"] == "nodes" ? "above" : "neither");
    }
}

TEST(Plugins, AnUnknownOneIsAnErrorWithASuggestion) {
    const Outcome unknown = Bench().stylet({"plugins", "frictoin"});
    EXPECT_EQ(unknown.code, 2);
    EXPECT_THAT(unknown.err, HasSubstr("friction"));
    EXPECT_THAT(unknown.out, IsEmpty());
}

TEST(Plugins, AreFoundInAFolderOfTheUsers) {
    const Bench bench;
    EXPECT_THAT(bench.stylet({"plugins"}).out, Not(HasSubstr("lost_hand")));
    EXPECT_THAT(bench.stylet({"plugins", "--plugin-dir", TEST_PLUGIN_FOLDER}).out, HasSubstr("lost_hand"));
}

TEST(Plugins, AFolderThatIsNotThereIsAWrongCommandLine) {
    const Outcome missing = Bench().stylet({"plugins", "--plugin-dir", "nowhere"});
    EXPECT_EQ(missing.code, 3);
    EXPECT_THAT(missing.err, HasSubstr("nowhere"));
}

TEST(Plugins, ABrokenLibraryIsToldOfBesideTheOthers) {
    const Bench bench;
    std::filesystem::create_directory(bench.path("broken"));
    bench.write("broken/squashed.so", "no library");
    const Outcome list = bench.stylet({"plugins", "--plugin-dir", "broken"});
    EXPECT_EQ(list.code, 0);
    EXPECT_THAT(list.err, HasSubstr("squashed"));
    EXPECT_THAT(list.out, HasSubstr("friction"));
    EXPECT_EQ(bench.stylet({"plugins", "squashed", "--plugin-dir", "broken"}).code, 2);
}

TEST(Scenes, AreListedWithTitlesAndCanBeRunByTheirPath) {
    const Bench bench;
    const Outcome list = bench.stylet({"scenes"});
    EXPECT_EQ(list.code, 0) << list.err;
    EXPECT_THAT(list.out, ContainsRegex("paper/fig10a_l150.yaml +Fig. 10\\(a\\): L = 150 mm\n"));
    EXPECT_THAT(list.out, ContainsRegex("paper/fig9.yaml +Fig. 9"));
    const std::string first = list.out.substr(0, list.out.find(' '));
    EXPECT_EQ(bench.stylet({"check", first}).code, 0) << first;
}

}    // namespace
}    // namespace stylet::commands
