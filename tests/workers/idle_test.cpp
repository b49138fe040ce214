// Who has nothing to do sleeps, wakes when there is something, and keeps nobody waiting.

#include "tests/workers/meeting.h"

#include <gtest/gtest.h>
#include <poll.h>

#include <algorithm>
#include <csignal>
#include <ctime>
#include <vector>

namespace stylet::core {
namespace {

using std::chrono::microseconds;
using std::chrono::milliseconds;

// Of processor time, in 200 ms: looking about for 20 µs and going to sleep takes far less, spinning takes all of it.
constexpr double next_to_nothing = 0.010;    // [s]
constexpr milliseconds watched{200};

double processor_time(clockid_t clock) {    // [s]
    timespec used{};
    clock_gettime(clock, &used);
    return static_cast<double>(used.tv_sec) + 1e-9 * static_cast<double>(used.tv_nsec);
}

class SharingPool : public testing::Test {
protected:
    void SetUp() override {
        if (processors() == 1) GTEST_SKIP() << "one processor: there is no worker";
    }
};

TEST_F(SharingPool, UsesNoProcessorWhileIdle) {
    WorkerPool pool(4);
    for (int run = 0; run < 100; ++run) pool.each(16, [](int) {});
    const double before = processor_time(CLOCK_PROCESS_CPUTIME_ID);
    std::this_thread::sleep_for(watched);
    const double used = processor_time(CLOCK_PROCESS_CPUTIME_ID) - before;
    std::printf("an idle pool used %.3f ms of processor time in %d ms\n", 1e3 * used, static_cast<int>(watched.count()));
    EXPECT_LT(used, next_to_nothing);
}

TEST_F(SharingPool, UsesNoProcessorWhileTheCallerWaitsForALateWorker) {
    WorkerPool pool(2);
    double before = 0.0;
    ASSERT_TRUE(meet(pool, [&] {
                    before = processor_time(CLOCK_PROCESS_CPUTIME_ID);    // the caller is about to leave its task
                    std::this_thread::sleep_for(watched);
                }).met);
    const double used = processor_time(CLOCK_PROCESS_CPUTIME_ID) - before;
    std::printf("waiting for %d ms used %.3f ms of processor time\n", static_cast<int>(watched.count()), 1e3 * used);
    EXPECT_LT(used, next_to_nothing);
}

// The pauses go from none to well past the 20 µs after which a worker falls asleep: a call that it slept through would show as a
// meeting that never is.
TEST_F(SharingPool, WakesAWorkerHoweverLongItHasBeenIdle) {
    constexpr int meetings = 2000;
    WorkerPool pool(2);
    for (int i = 0; i < meetings; ++i) {
        const Meeting meeting = meet(pool);
        ASSERT_TRUE(meeting.met || meeting.alone) << "meeting " << i;
        const auto until = std::chrono::steady_clock::now() + microseconds(i % 61);
        while (std::chrono::steady_clock::now() < until) continue;
    }
}

#ifndef __SANITIZE_THREAD__    // which keeps signals back until the thread makes a call that it knows

std::atomic<bool> held{false}, release{false};

void hold(int) {
    held = true;
    while (!release) poll(nullptr, 0, 1);
}

TEST_F(SharingPool, NeverWaitsForAWorkerThatHasNotBegun) {
    WorkerPool pool(2);
    pthread_t worker{};
    ASSERT_TRUE(meet(pool, [&] { worker = pthread_self(); }).met);
    std::signal(SIGUSR1, hold);
    pthread_kill(worker, SIGUSR1);
    ASSERT_TRUE(comes_true([] { return held.load(); }));

    constexpr int runs = 1000;
    const std::int64_t fallbacks = pool.fallbacks();
    int done = 0;
    for (int run = 0; run < runs; ++run) pool.each(16, [&](int) { ++done; });
    EXPECT_EQ(done, 16 * runs);
    EXPECT_EQ(pool.fallbacks(), fallbacks);

    release = true;
    EXPECT_TRUE(meet(pool).met);
    std::signal(SIGUSR1, SIG_DFL);
}

#endif

// Some 10 µs of work.
double root(int i) {
    double guess = 1.0;
    for (int k = 0; k < 1000; ++k) guess = 0.5 * (guess + (i + 1) / guess);
    return guess;
}

TEST_F(SharingPool, IsRightWhileOthersTakeEveryProcessor) {
    std::atomic<bool> enough{false};
    std::vector<std::thread> others;
    for (int i = 0; i < processors() + 1; ++i) {
        others.emplace_back([&] {
            while (!enough) continue;
        });
    }
    constexpr int runs = 300, tasks = 16;
    std::vector<double> expected(tasks), found(tasks);
    for (int i = 0; i < tasks; ++i) expected[static_cast<std::size_t>(i)] = root(i);
    WorkerPool pool(processors());
    int right = 0;
    for (int run = 0; run < runs; ++run) {
        std::fill(found.begin(), found.end(), 0.0);
        pool.each(tasks, [&](int i) { found[static_cast<std::size_t>(i)] = root(i); });
        right += found == expected;
    }
    enough = true;
    for (std::thread& other : others) other.join();
    std::printf("%d runs on a busy machine: fell back %d times, did %d runs alone\n", runs, static_cast<int>(pool.fallbacks()),
                static_cast<int>(pool.runs_alone()));
    EXPECT_EQ(right, runs);
}

}    // namespace
}    // namespace stylet::core
