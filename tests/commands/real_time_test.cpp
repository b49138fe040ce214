// `stylet run --real-time` as a user meets it; what the loop itself does is tested in tests/real_time.
#include "tests/commands/command.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <sys/wait.h>

#include <cstdlib>

namespace stylet::commands {
namespace {

using nlohmann::ordered_json;
using testing::HasSubstr;

/// The paper's insertion at ten times its speed: a second long.
std::vector<std::string> fast(const std::string& name, std::vector<std::string> more) {
    std::vector<std::string> arguments{"run", paper(name), "--real-time", "--set", "device.motion[0].speed=100 mm/s"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
}

TEST(RealTime, TellsWhatTheSystemGrantedAndHowLateItWas) {
    const Bench bench;
    const Outcome run = bench.stylet(fast("fig10a_l150", {}));
    EXPECT_EQ(run.code, 0) << run.err;
    for (const char* words : {"  real time\n", "scheduling   SCHED_FIFO", "memory       lock", "overruns", "periods given up",
                              "after the deadline   woke   device answered", " µs "}) {
        EXPECT_THAT(run.out, HasSubstr(words));
    }
    EXPECT_TRUE(bench.has("out/fig10a_l150.csv"));
}

TEST(RealTime, LeavesItsHistogramInTheJson) {
    const Outcome run = Bench().stylet(fast("fig10a_l150", {"--json", "-"}));
    ASSERT_EQ(run.code, 0) << run.err;
    const ordered_json loop = ordered_json::parse(run.out)["real_time"];
    const ordered_json& latency = loop["latency_us"];
    ASSERT_EQ(latency["woke"].size(), latency["upper_bounds"].size() + 1);
    std::size_t ticks = 0;
    for (const ordered_json& count : latency["answered"]) ticks += count.get<std::size_t>();
    EXPECT_EQ(ticks, 800U);
    EXPECT_GE(loop["wall_time"].get<double>(), 0.8);
}

TEST(RealTime, HasNoPlaceForPictures) {
    const Outcome run = Bench().stylet(fast("fig10a_l150", {"--vtu", "pictures"}));
    EXPECT_EQ(run.code, 3);
    EXPECT_THAT(run.err, HasSubstr("--real-time"));
}

TEST(RealTime, WantsAtLeastOneThread) {
    const Outcome run = Bench().stylet(fast("fig10a_l150", {"--threads", "0"}));
    EXPECT_EQ(run.code, 3);
    EXPECT_THAT(run.err, HasSubstr("--threads"));
}

TEST(RealTime, KeepsWhatWasDoneUntilCtrlC) {
    const Bench bench;
    const std::string command =
        "cd '" + bench.path("").string() + "' && { '" STYLET_EXECUTABLE "' run '" + paper("fig10a_l150") + "' '" + paper("fig9") +
        "' --set 'run.duration=100000 s' --real-time > said.txt 2> complained.txt & "
        "until grep -qs '^0.0' out/fig10a_l150.csv; do kill -0 $! || exit 1; sleep 0.05; done; kill -INT $!; wait $!; }";
    const int status = std::system(command.c_str());
    ASSERT_TRUE(WIFEXITED(status));
    EXPECT_EQ(WEXITSTATUS(status), 130);
    EXPECT_THAT(bench.read("said.txt"), HasSubstr("energy ledger"));
    EXPECT_THAT(bench.read("said.txt"), HasSubstr("stopped before the scene was over"));
    EXPECT_EQ(bench.read("complained.txt"), paper("fig9") + ": not run: stopped by Ctrl-C\n");
    EXPECT_FALSE(bench.has("out/fig9.csv"));
    EXPECT_EQ(bench.read("out/fig10a_l150.csv").back(), '\n');
}

}    // namespace
}    // namespace stylet::commands
