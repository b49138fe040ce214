// Same scene, same build: the same bytes. And no allocation in a tick.
#include "core/run/run.h"
#include "tests/commands/command.h"
#include "tests/whole_scenes/trace.h"

#include <stylet/contract/allocations.h>

#include <gtest/gtest.h>

namespace stylet::whole_scenes {
namespace {

TEST(Recording, IsTheSameToTheByteInOneProcessAndInSeveral) {
    const commands::Bench bench;
    const core::Scene scene = core::read_scene(paper_scene("fig9"), {}, plugin_folders());
    for (const char* name : {"first.csv", "second.csv"}) {
        (void)core::run(scene, plugin_folders(), {.recording = bench.path(name), .progress = {}, .observe = {}});
    }
    for (const char* folder : {"third", "fourth"}) {
        ASSERT_EQ(bench.stylet({"run", paper_scene("fig9").string(), "--out", folder, "--quiet"}).code, 0);
    }
    const std::string first = bench.read("first.csv");
    measured("bytes", static_cast<double>(first.size()));
    ASSERT_GT(first.size(), 1'000'000u) << "ten thousand rows";
    EXPECT_TRUE(first == bench.read("second.csv"));
    EXPECT_TRUE(first == bench.read("third/fig9.csv"));
    EXPECT_TRUE(first == bench.read("fourth/fig9.csv"));
}

TEST(Tick, AllocatesNothingInAllOfFigure9) {
    Stage stage(paper_scene("fig9"));
    core::Simulation& simulation = stage.simulation();
    std::size_t events = 0;
    const std::size_t before = contract::allocations(), ticks = stage.ticks();
    for (std::size_t tick = 0; tick < ticks; ++tick) {
        simulation.tick();
        events += simulation.events().size();
    }
    EXPECT_EQ(contract::allocations() - before, 0u);
    EXPECT_GE(events, 5u) << "an allocation at an event would not have been seen";
}

TEST(Tick, AllocatesNothingOnTheWayOutAndInAgain) {
    Stage stage(own_scene("stroke"), {{"device.cycles", "3"}});
    core::Simulation& simulation = stage.simulation();
    const std::size_t before = contract::allocations(), ticks = stage.ticks();
    for (std::size_t tick = 0; tick < ticks; ++tick) simulation.tick();
    EXPECT_EQ(contract::allocations() - before, 0u);
}

TEST(Tick, IsWatchedByACounterThatCounts) {
    const std::size_t before = contract::allocations();
    double* const volatile some = new double[100];    // volatile: clang leaves out an allocation that nobody sees
    EXPECT_GT(contract::allocations(), before);
    delete[] some;
}

}    // namespace
}    // namespace stylet::whole_scenes
