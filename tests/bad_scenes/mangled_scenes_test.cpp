// Whatever a scene's bytes are, reading them ends in a scene or in SceneErrors, and in good time.
#include "core/scene/reader.h"

#include <gtest/gtest.h>

#include <array>
#include <fstream>
#include <random>
#include <sstream>

namespace stylet::core {
namespace {

namespace fs = std::filesystem;

/// A scene file in a folder that goes with the test.
class MangledScene : public testing::Test {
protected:
    MangledScene() {
        std::string name = (fs::temp_directory_path() / "stylet_XXXXXX").string();
        folder_ = mkdtemp(name.data());
        fs::create_directory(folder_ / "hands");
        std::ofstream(folder_ / "hands/steady.csv") << "time [s],z [m]\n0,0\n";
    }
    ~MangledScene() override { fs::remove_all(folder_); }

    /// The messages of a scene of this text; none where it is good. Anything thrown but SceneErrors fails the test.
    std::vector<std::string> read(const std::string& text) const {
        const fs::path file = folder_ / "scene.yaml";
        std::ofstream(file, std::ios::binary) << text;
        try {
            (void)read_scene(file, {}, PluginFolders({TEST_PLUGINS}));
            return {};
        } catch (const SceneErrors& errors) {
            EXPECT_FALSE(errors.messages().empty());
            return errors.messages();
        }
    }

    [[nodiscard]] static std::string good_text() {
        std::ostringstream text;
        text << std::ifstream("../loading/good.yaml").rdbuf();
        return text.str();
    }

private:
    fs::path folder_;
};

/// The characters that mean something to YAML and to units, and some that mean nothing to either.
constexpr std::string_view telling = "{}[]:,-#&*!|>'\"%@`?~ \n\t^/.0123456789eExX\0\x01\x7f\x80\xc3\xb5\xff";

std::string mangled(std::string text, std::mt19937& random) {
    const auto any_below = [&](std::size_t bound) { return std::uniform_int_distribution<std::size_t>(0, bound - 1)(random); };
    for (std::size_t times = 1 + any_below(4); times > 0 && !text.empty(); --times) {
        const std::size_t at = any_below(text.size());
        const std::size_t length = std::min(text.size() - at, 1 + any_below(20));
        const char letter = any_below(2) == 0 ? telling[any_below(telling.size())] : static_cast<char>(any_below(256));
        switch (any_below(5)) {
            case 0:
                text[at] = letter;
                break;
            case 1:
                text.insert(at, 1 + any_below(3), letter);
                break;
            case 2:
                text.erase(at, length);
                break;
            case 3:
                text.insert(any_below(text.size()), text.substr(at, length));
                break;
            default:
                text.resize(std::max<std::size_t>(at, 1));
                break;
        }
    }
    return text;
}

TEST_F(MangledScene, IsGoodBeforeItIsMangled) {
    EXPECT_TRUE(read(good_text()).empty());
}

TEST_F(MangledScene, NeverCrashesTheReader) {
    constexpr int scenes = 4000;
    std::mt19937 random(20060);    // any seed will do; this one is written down
    const std::string good = good_text();
    int refused = 0;
    for (int i = 0; i < scenes; ++i) {
        const std::string text = mangled(good, random);
        SCOPED_TRACE(text);
        refused += read(text).empty() ? 0 : 1;
        if (HasFailure()) return;
    }
    EXPECT_GT(refused, scenes / 2) << "the mangling mangles too little to test anything";
}

TEST_F(MangledScene, OfRandomBytesNeverCrashesTheReader) {
    constexpr int scenes = 1000;
    std::mt19937 random(20061);
    for (int i = 0; i < scenes; ++i) {
        std::string text(1 + random() % 200, ' ');
        for (char& letter : text) letter = telling[random() % telling.size()];
        SCOPED_TRACE(text);
        EXPECT_FALSE(read(text).empty());
    }
}

TEST_F(MangledScene, NestedDeeplyIsRefused) {
    constexpr std::size_t depth = 100000;
    std::string indented;
    for (std::size_t i = 0; i < 1000; ++i) indented += std::string(i, ' ') + "a:\n";
    std::string dashes;
    for (std::size_t i = 0; i < 5000; ++i) dashes += "- ";
    const std::array<std::string, 5> texts{std::string(depth, '['), "a: " + std::string(depth, '{'),
                                           std::string(depth, '[') + std::string(depth, ']'), indented, dashes};
    for (const std::string& text : texts) EXPECT_EQ(read(text).size(), 1u);
    const std::string just_too_deep = "a: " + std::string(65, '[') + std::string(65, ']');
    const std::vector<std::string> messages = read(just_too_deep);
    ASSERT_EQ(messages.size(), 1u);
    EXPECT_TRUE(messages[0].ends_with("scene.yaml:1:67: found values nested deeper than 64")) << messages[0];
}

TEST_F(MangledScene, TooLongIsRefusedUnread) {
    const std::vector<std::string> messages = read(std::string((1 << 20) + 1, '#'));
    ASSERT_EQ(messages.size(), 1u);
    EXPECT_TRUE(messages[0].ends_with("found a file of 1048577 bytes (at most 1048576 are read), wanted a scene")) << messages[0];
}

TEST_F(MangledScene, IsRefusedInShortSentencesHoweverLongItsWordsAre) {
    constexpr std::size_t longest = 500;              // [bytes]
    const std::string no_character(10000, '\x80');    // of UTF-8: it has neither beginning nor end
    const std::array<std::string, 3> texts{good_text() + std::string(10000, 'k') + ": 1\n", no_character,
                                           "stylet: " + no_character};
    for (const std::string& text : texts) {
        const std::vector<std::string> messages = read(text);
        EXPECT_FALSE(messages.empty());
        for (const std::string& message : messages) EXPECT_LE(message.size(), longest) << message.substr(0, longest);
    }
}

TEST_F(MangledScene, OfManyKeysIsReadInGoodTime) {
    std::string keys;
    for (int i = 0; i < 20000; ++i) keys += "key" + std::to_string(i) + ": [1, 2]\n";
    EXPECT_GT(read(keys).size(), 20000u);
}

TEST_F(MangledScene, CannotGrowByAliases) {
    std::string bomb = "a0: &a0 [x, x, x, x, x, x, x, x, x]\n";
    for (int i = 1; i < 30; ++i) {
        std::string key = "a";
        key += std::to_string(i);
        bomb += key + ": &" + key + " [";
        for (int copies = 0; copies < 9; ++copies) bomb += "*a" + std::to_string(i - 1) + " , ";
        bomb += "]\n";
    }
    const std::vector<std::string> messages = read(bomb);
    ASSERT_EQ(messages.size(), 1u);
    EXPECT_TRUE(messages[0].ends_with(":2:10: found an alias ('*name'), wanted the value itself: a scene writes every value out"))
        << messages[0];
}

}    // namespace
}    // namespace stylet::core
