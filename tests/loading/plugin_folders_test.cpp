#include "core/loading/plugin_folders.h"

#include "test_scenes.h"

#include <gtest/gtest.h>

#include <cstdlib>

namespace stylet::core {
namespace {

TEST(PluginFolders, FindsAFileByItsNameInTheFirstFolderThatHasIt) {
    const PluginFolders folders({BAD_PLUGINS, GOOD_PLUGINS});
    EXPECT_EQ(folders.find("friction"), std::filesystem::path(GOOD_PLUGINS) / "friction.so");
    EXPECT_EQ(folders.find("other_sdk"), std::filesystem::path(BAD_PLUGINS) / "other_sdk.so");
}

TEST(PluginFolders, NeverLeaveTheFolder) {
    const PluginFolders folders({GOOD_PLUGINS});
    EXPECT_FALSE(folders.find("../good_plugins/friction"));
    EXPECT_FALSE(folders.find(std::string(GOOD_PLUGINS) + "/friction"));
    EXPECT_FALSE(folders.find(""));
}

TEST(PluginFolders, ListTheNamesOfAllLibraries) {
    const std::vector<std::string> names = PluginFolders({GOOD_PLUGINS, "/nowhere"}).names();
    const std::vector<std::string> expected{"beam_column", "euler",         "fracture", "friction", "half_space",
                                            "lattice",     "recorded_hand", "strut",    "throwing"};
    EXPECT_EQ(names, expected);
}

TEST(PluginFolders, PutTheUsersFoldersBeforeTheEnvironmentsAndTheInstallsLast) {
    setenv("STYLET_PLUGIN_PATH", "/from/environment::/and/another", 1);
    const auto folders = PluginFolders::standard({"/given"}).folders();
    unsetenv("STYLET_PLUGIN_PATH");
    ASSERT_EQ(folders.size(), 4u);
    EXPECT_EQ(folders[0], "/given");
    EXPECT_EQ(folders[1], "/from/environment");
    EXPECT_EQ(folders[2], "/and/another");
    const auto program = std::filesystem::read_symlink("/proc/self/exe");
    EXPECT_EQ(folders[3], program.parent_path().parent_path() / "lib/stylet/plugins");
}

}    // namespace
}    // namespace stylet::core
