// The loop on the wall clock: what it does, however busy the machine is.
#include "core/run/real_time_loop.h"
#include "core/run/run.h"
#include "core/scene/reader.h"

#include <gtest/gtest.h>
#include <stylet/error.h>

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <numeric>
#include <string>
#include <thread>
#include <vector>

namespace stylet::core {
namespace {

constexpr double period = 1e-3;    // [s]
const std::atomic<bool> never{false};

std::size_t total(const Latency& latency) {
    return std::accumulate(latency.counts().begin(), latency.counts().end(), std::size_t{0});
}

/// Work that only ticks, and has nothing to let go.
RealTimeLoop::Work ticking(
    std::function<void()> tick, std::function<bool()> note = [] { return true; }) {
    return {[tick = std::move(tick)](double) { tick(); }, std::move(note), [] { return false; }};
}

TEST(RealTimeLoop, TicksAsOftenAsItIsToldOnAThreadOfItsOwn) {
    constexpr std::size_t ticks = 50;
    std::size_t done = 0, noted = 0;
    std::thread::id thread;
    const RealTimeReport report = RealTimeLoop(period).run(
        ticks, ticking([&] { ++done, thread = std::this_thread::get_id(); }, [&] { return ++noted == done; }), {}, never);
    EXPECT_EQ(done, ticks);
    EXPECT_EQ(noted, ticks);
    EXPECT_NE(thread, std::this_thread::get_id());
    EXPECT_EQ(total(report.woke), ticks);
    EXPECT_EQ(total(report.answered), ticks);
    EXPECT_EQ(report.lost_rows, 0u);
}

TEST(RealTimeLoop, NeverRunsAheadOfTheClock) {
    constexpr std::size_t ticks = 40;
    const auto start = std::chrono::steady_clock::now();
    std::vector<double> at;    // [s]
    at.reserve(ticks);
    const auto note_time = [&] { at.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count()); };
    const RealTimeReport report = RealTimeLoop(period).run(ticks, ticking(note_time), {}, never);
    for (std::size_t i = 0; i < ticks; ++i) EXPECT_GE(at[i], static_cast<double>(i + 1) * period) << "tick " << i;
    EXPECT_GE(report.wall_time, static_cast<double>(ticks) * period);
}

TEST(RealTimeLoop, GivesUpThePeriodsThatALongTickHasMissed) {
    std::size_t done = 0;
    const auto tick = [&] {
        if (++done == 5) std::this_thread::sleep_for(std::chrono::milliseconds(20));
    };
    const RealTimeReport report = RealTimeLoop(period).run(10, ticking(tick), {}, never);
    EXPECT_EQ(done, 10u) << "ticks are not given up, only deadlines";
    EXPECT_GE(report.overruns, 1u);
    EXPECT_GE(report.skipped, 19u) << "twenty periods, of which the next tick's own may just be kept";
    EXPECT_GE(report.answered.worst(), 20e3);
}

TEST(RealTimeLoop, CountsTheRowsThatFoundNoRoom) {
    std::size_t done = 0;
    const RealTimeReport report =
        RealTimeLoop(period).run(10, ticking([&] { ++done; }, [&] { return done % 2 == 0; }), {}, never);
    EXPECT_EQ(report.lost_rows, 5u);
}

TEST(RealTimeLoop, EndsWhenItIsAskedTo) {
    std::atomic<bool> stop{false};
    std::size_t done = 0;
    const auto tick = [&] {
        if (++done == 7) stop = true;
    };
    (void)RealTimeLoop(period).run(1'000'000, ticking(tick), {}, stop);
    EXPECT_EQ(done, 7u);
}

TEST(RealTimeLoop, LetsGoInTheEnd) {
    int left = 20;
    std::size_t done = 0;
    RealTimeLoop::Work work = ticking([&] { ++done; });
    work.let_go = [&] { return done == 5 && --left > 0; };
    (void)RealTimeLoop(period).run(5, work, {}, never);
    EXPECT_EQ(left, 0);
}

TEST(RealTimeLoop, TellsATickForHowLongTheLastForceWasHeld) {
    std::vector<double> held;    // [s]
    held.reserve(10);
    RealTimeLoop::Work work = ticking([] {});
    work.tick = [&](double time) {
        held.push_back(time);
        if (held.size() == 5) std::this_thread::sleep_for(std::chrono::milliseconds(20));
    };
    (void)RealTimeLoop(period).run(10, work, {}, never);
    ASSERT_EQ(held.size(), 10u);
    EXPECT_GE(held[5], 20e-3) << "while the fifth tick was stuck, the force of the fourth stood";
}

TEST(RealTimeLoop, EndsWhereItsWatchThrows) {
    std::size_t done = 0;
    bool let_go = false;
    RealTimeLoop::Work work = ticking([&] { ++done; });
    work.let_go = [&] { return let_go = true, false; };
    const auto watch = [](std::size_t) { throw Error("enough"); };
    EXPECT_THROW((void)RealTimeLoop(period).run(1'000'000, work, watch, never), Error);
    EXPECT_LT(done, 1'000'000u);
    EXPECT_TRUE(let_go);
}

TEST(RealTimeLoop, TellsHowFarItIs) {
    std::size_t last = 0;
    bool rising = true;
    const auto watch = [&](std::size_t done) {
        rising = rising && done >= last;
        last = done;
    };
    (void)RealTimeLoop(period).run(200, ticking([] {}), watch, never);
    EXPECT_GT(last, 0u);
    EXPECT_TRUE(rising);
}

TEST(RealTimeLoop, SaysWhatTheSystemGranted) {
    const RealTimeReport report = RealTimeLoop(period).run(1, ticking([] {}), {}, never);
    std::printf("scheduling: %s; memory: %s\n", report.scheduling.c_str(), report.memory.c_str());
    EXPECT_EQ(report.scheduling.find("SCHED_FIFO"), 0u);
    const bool plain = report.memory == "locked" || report.memory.starts_with("lock not granted (");
    EXPECT_TRUE(plain) << report.memory;
}

std::string contents(const std::filesystem::path& file) {
    std::ifstream stream(file);
    return {std::istreambuf_iterator<char>(stream), {}};
}

TEST(RealTimeRun, LeavesTheSameRecordingAsTheVirtualClock) {
    const PluginFolders folders({PLUGIN_FOLDER});
    // Fast, so that buckling and rupture come within a second.
    const Scene scene = read_scene(SCENE_FOLDER "/paper/fig10a_l150.yaml", {{"device.motion[0].speed", "100 mm/s"}}, folders);
    const std::filesystem::path folder = testing::TempDir() + "real_time_" + std::to_string(getpid());
    std::filesystem::create_directory(folder);
    const RunReport virtual_clock = run(scene, folders, {.recording = folder / "virtual.csv"});
    const RunReport wall_clock = run_in_real_time(scene, folders, {.recording = folder / "wall.csv"});
    ASSERT_TRUE(wall_clock.real_time);
    EXPECT_FALSE(virtual_clock.real_time);
    EXPECT_EQ(wall_clock.ticks, virtual_clock.ticks);
    if (wall_clock.real_time->lost_rows == 0) {
        EXPECT_EQ(contents(folder / "wall.csv"), contents(folder / "virtual.csv"));
    }
    std::filesystem::remove_all(folder);
    EXPECT_EQ(wall_clock.events.size(), virtual_clock.events.size());
    EXPECT_EQ(wall_clock.peak_hand_force, virtual_clock.peak_hand_force);
}

}    // namespace
}    // namespace stylet::core
