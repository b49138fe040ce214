#include "tests/commands/command.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace stylet::commands {
namespace {

using testing::HasSubstr;

TEST(CommandLine, HelpNamesEveryCommandAndExitCode) {
    const Outcome help = Bench().stylet({"--help"});
    EXPECT_EQ(help.code, 0);
    for (const char* word : {"  run ", "  check ", "  plugins ", "  scenes ", "  plot ", "  schema ", "Exit codes:", "  0 ",
                             "  1 ", "  2 ", "  3 ", "  4 "}) {
        EXPECT_THAT(help.out, HasSubstr(word));
    }
}

TEST(CommandLine, EveryCommandsHelpHasAnExampleAndItsExitCodes) {
    const Bench bench;
    for (const std::string command : {"run", "check", "plugins", "scenes", "plot", "schema"}) {
        const Outcome help = bench.stylet({command, "--help"});
        EXPECT_EQ(help.code, 0) << command;
        EXPECT_THAT(help.out, HasSubstr("  stylet " + command));
        EXPECT_THAT(help.out, HasSubstr("Exit codes:")) << command;
    }
}

TEST(CommandLine, VersionIsTheProjects) {
    const Outcome version = Bench().stylet({"--version"});
    EXPECT_EQ(version.code, 0);
    EXPECT_EQ(version.out, "stylet " STYLET_VERSION "\n");
}

TEST(CommandLine, NoCommandIsAWrongCommandLine) {
    const Outcome nothing = Bench().stylet({});
    EXPECT_EQ(nothing.code, 3);
    EXPECT_EQ(nothing.err,
              "stylet: found no command, wanted run, check, plugins, scenes, plot, schema, critical-load, study or advise; "
              "stylet --help tells more\n");
}

TEST(CommandLine, AnUnknownCommandIsNamed) {
    const Outcome unknown = Bench().stylet({"insert"});
    EXPECT_EQ(unknown.code, 3);
    EXPECT_THAT(unknown.err, HasSubstr("insert"));
}

TEST(CommandLine, AnUnknownOptionIsNamed) {
    const Outcome unknown = Bench().stylet({"run", paper("fig9"), "--speed", "3"});
    EXPECT_EQ(unknown.code, 3);
    EXPECT_THAT(unknown.err, HasSubstr("--speed"));
}

TEST(CommandLine, RunWithoutASceneSaysWhatIsMissing) {
    const Outcome bare = Bench().stylet({"run"});
    EXPECT_EQ(bare.code, 3);
    EXPECT_THAT(bare.err, HasSubstr("SCENE"));
}

}    // namespace
}    // namespace stylet::commands
