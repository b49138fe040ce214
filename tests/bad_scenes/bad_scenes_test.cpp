// Each bad scene here is refused with the messages in the file beside it: those of this folder as they are read, with plugins of
// the tests' own, those of refused_by_plugins when the real plugins are made. `<plugins>` stands for the folder of the plugins,
// `<here>` for this one.
#include "core/loading/cast.h"
#include "core/scene/reader.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <sstream>

namespace stylet::core {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> bad_scenes(const fs::path& folder) {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder)) {
        if (entry.path().extension() == ".yaml") names.push_back(entry.path().stem().string());
    }
    std::ranges::sort(names);
    return names;
}

std::string contents(const fs::path& file) {
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    return text.str();
}

void replace_all(std::string& text, const std::string& what, const std::string& with) {
    for (auto at = text.find(what); at != std::string::npos; at = text.find(what)) text.replace(at, what.size(), with);
}

std::string messages_of(const std::string& scene, const std::string& folder = TEST_PLUGINS) {
    std::string text;
    try {
        const PluginFolders folders({folder});
        const Scene read = read_scene(scene + ".yaml", {}, folders);
        const Cast cast(read, folders);
    } catch (const SceneErrors& errors) {
        for (const std::string& message : errors.messages()) text += message + "\n";
    }
    replace_all(text, folder, "<plugins>");
    replace_all(text, fs::current_path().string(), "<here>");
    return text;
}

void expect_these_words(const std::string& scene, const std::string& folder) {
    const fs::path pinned = scene + ".expected";
    ASSERT_TRUE(fs::exists(pinned)) << "pin these words if they are right:\n" << messages_of(scene, folder);
    EXPECT_EQ(messages_of(scene, folder), contents(pinned));
}

class BadScene : public testing::TestWithParam<std::string> {};

TEST_P(BadScene, IsRefusedInTheseWords) {
    expect_these_words(GetParam(), TEST_PLUGINS);
}

INSTANTIATE_TEST_SUITE_P(All, BadScene, testing::ValuesIn(bad_scenes(".")), [](const auto& bad) { return bad.param; });

class SceneRefusedByPlugins : public testing::TestWithParam<std::string> {};

TEST_P(SceneRefusedByPlugins, IsRefusedInTheseWords) {
    expect_these_words("refused_by_plugins/" + GetParam(), PLUGINS);
}

INSTANTIATE_TEST_SUITE_P(All, SceneRefusedByPlugins, testing::ValuesIn(bad_scenes("refused_by_plugins")),
                         [](const auto& bad) { return bad.param; });

TEST(BadScenes, CoverEachKindOfMistake) {
    EXPECT_GE(bad_scenes(".").size(), 15u);
}

TEST(BadScenes, MayBeMissingAltogether) {
    EXPECT_EQ(messages_of("no_such_scene"), "no_such_scene.yaml: found no such file, wanted a scene\n");
}

TEST(BadScenes, MayBeAFolder) {
    try {
        (void)read_scene("hands", {}, PluginFolders({TEST_PLUGINS}));
        FAIL() << "a folder was read as a scene";
    } catch (const SceneErrors& errors) {
        EXPECT_STREQ(errors.what(), "hands: found something that is no file, wanted a scene");
    }
}

}    // namespace
}    // namespace stylet::core
