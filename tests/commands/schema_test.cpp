// `stylet schema`, and the Markdown pages of `stylet plugins --pages`. What the schema says is ../schema's matter.
#include "tests/commands/command.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace stylet::commands {
namespace {

using nlohmann::json;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

/// A folder in which a library is none.
void break_a_library(const Bench& bench) {
    std::filesystem::create_directory(bench.path("broken"));
    bench.write("broken/squashed.so", "no library");
}

TEST(Schema, IsPrintedAsJson) {
    const Outcome schema = Bench().stylet({"schema"});
    EXPECT_EQ(schema.code, 0) << schema.err;
    EXPECT_EQ(json::parse(schema.out)["$schema"], "http://json-schema.org/draft-07/schema#");
    EXPECT_THAT(schema.err, IsEmpty());
}

TEST(Schema, IsWrittenToAFileAndTheFileNamed) {
    const Bench bench;
    const Outcome schema = bench.stylet({"schema", "--out", "scene.json"});
    EXPECT_EQ(schema.code, 0) << schema.err;
    EXPECT_EQ(schema.out, "scene.json\n");
    EXPECT_EQ(bench.read("scene.json"), bench.stylet({"schema"}).out);
}

TEST(Schema, NamesTheUsersPluginsToo) {
    const Bench bench;
    EXPECT_THAT(bench.stylet({"schema"}).out, Not(HasSubstr("lost_hand")));
    const json schema = json::parse(bench.stylet({"schema", "--plugin-dir", TEST_PLUGIN_FOLDER}).out);
    EXPECT_TRUE(schema["definitions"].contains("lost_hand"));
}

TEST(Schema, TellsOfABrokenLibraryAndLeavesItOut) {
    const Bench bench;
    break_a_library(bench);
    const Outcome schema = bench.stylet({"schema", "--plugin-dir", "broken"});
    EXPECT_EQ(schema.code, 0);
    EXPECT_THAT(schema.err, HasSubstr("squashed"));
    EXPECT_FALSE(json::parse(schema.out)["definitions"].contains("squashed"));
}

TEST(Schema, AFolderThatIsNotThereIsOneSentence) {
    const Outcome schema = Bench().stylet({"schema", "--out", "nowhere/scene.json"});
    EXPECT_EQ(schema.code, 4);
    EXPECT_EQ(schema.err, "nowhere/scene.json: cannot be written: No such file or directory\n");
    EXPECT_THAT(schema.out, IsEmpty());
}

TEST(Schema, APluginFolderThatIsNotThereIsAWrongCommandLine) {
    const Outcome schema = Bench().stylet({"schema", "--plugin-dir", "nowhere"});
    EXPECT_EQ(schema.code, 3);
    EXPECT_THAT(schema.err, HasSubstr("nowhere"));
}

TEST(Schema, TakesNoScene) {
    const Outcome schema = Bench().stylet({"schema", paper("fig9")});
    EXPECT_EQ(schema.code, 3);
    EXPECT_THAT(schema.err, HasSubstr("fig9"));
}

TEST(Pages, AreOneForEachPluginAndAnIndex) {
    const Bench bench;
    const Outcome pages = bench.stylet({"plugins", "--pages", "made/pages"});
    EXPECT_EQ(pages.code, 0) << pages.err;
    EXPECT_THAT(pages.out, HasSubstr("made/pages/README.md\n"));
    for (const json& plugin : json::parse(bench.stylet({"plugins", "--json"}).out)) {
        const std::string name = plugin["name"];
        EXPECT_THAT(pages.out, HasSubstr("made/pages/" + name + ".md\n"));
        EXPECT_THAT(bench.read("made/pages/README.md"), HasSubstr("[" + name + "](" + name + ".md)"));
        EXPECT_THAT(bench.read("made/pages/" + name + ".md"), HasSubstr("# " + name + "\n"));
    }
}

TEST(Pages, SayWhatThePluginSaysOfItselfAndHowItStandsInAScene) {
    const Bench bench;
    ASSERT_EQ(bench.stylet({"plugins", "--pages", "."}).code, 0);
    const std::string friction = bench.read("friction.md");
    EXPECT_THAT(friction, HasSubstr("| `per_length` | number (N/m) | ≥ 0 | required | "));
    EXPECT_THAT(friction, HasSubstr("```yaml\neffects:\n  - type: friction\n    per_length: <number> N/m\n"));
    EXPECT_THAT(friction, ContainsRegex("## Formula\n\n```text\n.+\n```"));
    EXPECT_THAT(friction, ContainsRegex("## Validity\n\n[A-Z]"));
    EXPECT_THAT(friction, ContainsRegex("## Source\n\nOkamura"));
    EXPECT_THAT(bench.read("recorded_hand.md"), HasSubstr("| `motion[].insert` | number (m) | > 0 | optional | "));
    EXPECT_THAT(bench.read("half_space.md"), HasSubstr("| `layers[].youngs_modulus` | number (Pa) | > 0 | required | "));
}

TEST(Pages, AFileWhereTheFolderShouldBeIsOneSentence) {
    const Bench bench;
    bench.write("taken", "a file");
    const Outcome pages = bench.stylet({"plugins", "--pages", "taken"});
    EXPECT_EQ(pages.code, 4);
    EXPECT_THAT(pages.err, StartsWith("taken: "));
    EXPECT_EQ(bench.stylet({"plugins", "--pages", "taken/below"}).code, 4);
}

TEST(Pages, APageThatCannotBeWrittenIsOneSentence) {
    const Bench bench;
    std::filesystem::create_directories(bench.path("pages/friction.md"));
    const Outcome pages = bench.stylet({"plugins", "--pages", "pages"});
    EXPECT_EQ(pages.code, 4);
    EXPECT_EQ(pages.err, "pages/friction.md: cannot be written: Is a directory\n");
}

TEST(Pages, AreOfAllPluginsOrNone) {
    const Bench bench;
    for (const std::string surplus : {"friction", "--json"}) {
        const Outcome pages = bench.stylet({"plugins", surplus, "--pages", "pages"});
        EXPECT_EQ(pages.code, 3) << surplus;
        EXPECT_THAT(pages.err, HasSubstr("--pages"));
        EXPECT_FALSE(bench.has("pages"));
    }
}

TEST(Pages, TellOfABrokenLibraryAndLeaveItOut) {
    const Bench bench;
    break_a_library(bench);
    const Outcome pages = bench.stylet({"plugins", "--pages", "pages", "--plugin-dir", "broken"});
    EXPECT_EQ(pages.code, 0);
    EXPECT_THAT(pages.err, HasSubstr("squashed"));
    EXPECT_FALSE(bench.has("pages/squashed.md"));
    EXPECT_TRUE(bench.has("pages/friction.md"));
}

}    // namespace
}    // namespace stylet::commands
