#include "apps/study/machine.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <unistd.h>

#include <array>
#include <cstdio>
#include <fstream>
#include <sstream>

namespace stylet::study {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

TEST(ThisMachine, SaysWhatItsTimesAreWorth) {
    const Machine machine = this_machine();
    std::printf("%s x %d, %s, %s\n", machine.processor.c_str(), machine.processors, machine.system.c_str(),
                machine.build.c_str());
    EXPECT_FALSE(machine.processor.empty());
    EXPECT_GE(machine.processors, 1);
    EXPECT_THAT(machine.system, HasSubstr("Linux"));
    EXPECT_THAT(machine.build, StartsWith("stylet "));
    EXPECT_THAT(machine.build, testing::ContainsRegex("(g\\+\\+|clang) [0-9]+\\.[0-9]+\\.[0-9]+, "));
}

TEST(ThisMachine, KeepsItsNameToItself) {
    std::array<char, 256> name{};
    ASSERT_EQ(gethostname(name.data(), name.size() - 1), 0);
    const std::string host = name.data();
    std::istringstream words(this_machine().system);    // a short name may stand within a longer word
    for (std::string word; words >> word;) EXPECT_NE(word, host);
}

TEST(ValueIn, ReadsWhatFollowsAKey) {
    const std::filesystem::path file = testing::TempDir() + "value_in_" + std::to_string(getpid());
    std::ofstream(file) << "flags\nmodel name\t: A Processor @ 3 GHz\nmodel name\t: another\nPRETTY_NAME=\"A System 12\"\n";
    EXPECT_EQ(value_in(file, "model name"), "A Processor @ 3 GHz");
    EXPECT_EQ(value_in(file, "PRETTY_NAME"), "A System 12");
    EXPECT_EQ(value_in(file, "name"), "");
    std::filesystem::remove(file);
    EXPECT_EQ(value_in(file, "PRETTY_NAME"), "");
}

}    // namespace
}    // namespace stylet::study
