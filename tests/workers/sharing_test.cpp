// Whatever the threads do, the result is that of a plain loop.

#include "tests/workers/meeting.h"

#include <stylet/contract/allocations.h>

#include <gtest/gtest.h>
#include <pthread.h>
#include <sched.h>

#include <algorithm>
#include <numeric>
#include <vector>

namespace stylet::core {
namespace {

// More than this machine may have: then a thread loses its processor now and then in the middle of everything.
constexpr int threads = 4;

// How often each of `tasks` tasks is done. Plain integers: ThreadSanitizer sees whoever comes without being waited for.
std::vector<int> times_done(Workers& workers, int tasks) {
    std::vector<int> times(static_cast<std::size_t>(std::max(tasks, 0)), 0);
    workers.each(tasks, [&](int i) { ++times[static_cast<std::size_t>(i)]; });
    return times;
}

void expect_each_once(Workers& workers) {
    for (const int tasks : {-1, 0, 1, 2, 3, 4, 5, 100, 5000}) {
        EXPECT_EQ(times_done(workers, tasks), std::vector<int>(static_cast<std::size_t>(std::max(tasks, 0)), 1)) << tasks;
    }
}

TEST(OneThread, DoesEachTaskOnceInThisThread) {
    OneThread workers;
    EXPECT_EQ(workers.count(), 1);
    expect_each_once(workers);
}

TEST(WorkerPool, DoesEachTaskOnce) {
    for (int n = 1; n <= threads; ++n) {
        WorkerPool pool(n);
        EXPECT_EQ(pool.count(), processors() > 1 ? n : 1);
        expect_each_once(pool);
    }
}

TEST(WorkerPool, LendsNoThreadWhereNoneIsAskedFor) {
    for (const int n : {1, 0, -3}) {
        WorkerPool pool(n);
        EXPECT_EQ(pool.count(), 1);
        expect_each_once(pool);
    }
}

TEST(WorkerPool, MakesNoThreadOnOneProcessor) {
    std::thread([] {    // a thread of its own, for it stays on the one processor
        cpu_set_t all, one;
        ASSERT_EQ(sched_getaffinity(0, sizeof(all), &all), 0);
        CPU_ZERO(&one);
        for (int i = 0; i < CPU_SETSIZE && CPU_COUNT(&one) == 0; ++i) {
            if (CPU_ISSET(i, &all)) CPU_SET(i, &one);
        }
        ASSERT_EQ(sched_setaffinity(0, sizeof(one), &one), 0);
        EXPECT_EQ(processors(), 1);
        WorkerPool pool(threads);
        EXPECT_EQ(pool.count(), 1);
        expect_each_once(pool);
    })
        .join();
}

// Each run has its own function, context and memory, and takes them away when it ends: a worker that came late to one run and
// did its task in the next would leave a wrong number, or write where nobody lives.
TEST(WorkerPool, NeverDoesATaskOfOneRunInAnother) {
    constexpr int runs = 100'000;
    WorkerPool pool(threads);
    std::int64_t wrong = 0;
    for (int run = 0; run < runs; ++run) {
        std::vector<int> values(static_cast<std::size_t>(run % 18), -1);
        const auto fill = [&values, run](int i) { values[static_cast<std::size_t>(i)] = run + i; };
        const auto fill_twofold = [&values, run](int i) { values[static_cast<std::size_t>(i)] = 2 * (run + i); };
        run % 2 == 0 ? pool.each(run % 18, fill) : pool.each(run % 18, fill_twofold);
        for (int i = 0; i < run % 18; ++i) wrong += values[static_cast<std::size_t>(i)] != (1 + run % 2) * (run + i);
    }
    EXPECT_EQ(wrong, 0);
}

TEST(WorkerPool, GivesTheSameBitsAsAPlainLoop) {
    constexpr int tasks = 1000;
    const auto sums = [](Workers& workers) {
        std::vector<double> result(tasks);
        workers.each(tasks, [&](int i) {
            double sum = 0.0;
            for (int k = 1; k < 100; ++k) sum += 1.0 / (i + k * k);
            result[static_cast<std::size_t>(i)] = sum;
        });
        return result;
    };
    OneThread one;
    WorkerPool pool(threads);
    EXPECT_EQ(sums(pool), sums(one));
}

TEST(WorkerPool, MayBeTornDownAtAnyMoment) {
    constexpr int pools = 400;
    int done = 0;
    for (int i = 0; i < pools; ++i) {
        WorkerPool outer(1 + i % threads);
        if (i % 5 == 0) continue;    // before its threads have begun
        {
            WorkerPool inner(threads);
            for (int run = 0; run < i % 7; ++run) inner.each(3, [](int) {});
        }
        std::vector<int> times = times_done(outer, i % 30);
        done += std::accumulate(times.begin(), times.end(), 0) == i % 30;
    }
    EXPECT_EQ(done, pools - pools / 5);
}

TEST(WorkerPool, ServesAnotherThreadThanTheOneThatMadeIt) {
    WorkerPool pool(threads);
    for (int i = 0; i < 20; ++i) std::thread([&] { expect_each_once(pool); }).join();
}

TEST(WorkerPool, ServesTwoThreadsAtOnce) {
    constexpr int runs = 2000;
    WorkerPool pool(threads);
    const auto call_often = [&] {
        for (int i = 0; i < runs; ++i) ASSERT_EQ(times_done(pool, 7), std::vector<int>(7, 1));
    };
    std::thread other(call_often);
    call_often();
    other.join();
}

TEST(WorkerPool, MayBeCalledFromWithinATask) {
    constexpr int outer = 50, inner = 20;
    WorkerPool pool(threads);
    std::vector<std::vector<int>> times(outer);
    pool.each(outer, [&](int i) { times[static_cast<std::size_t>(i)] = times_done(pool, inner); });
    for (const auto& once : times) EXPECT_EQ(once, std::vector<int>(inner, 1));
}

TEST(WorkerPool, AllocatesNothingInARun) {
    WorkerPool pool(threads);
    std::vector<double> values(64);
    const auto square = [&](int i) { values[static_cast<std::size_t>(i)] *= values[static_cast<std::size_t>(i)]; };
    // A worker sets itself up when it first wakes: all of them must have, before anything is counted.
    std::atomic<int> awake{0};
    const auto long_enough = std::chrono::steady_clock::now() + std::chrono::seconds(2);    // on one processor there are none
    pool.each(threads, [&](int) {
        ++awake;
        while (awake < threads && std::chrono::steady_clock::now() < long_enough) std::this_thread::yield();
    });
    pool.each(64, square);
    const std::size_t before = contract::allocations();
    for (int run = 0; run < 1000; ++run) pool.each(64, square);
    EXPECT_EQ(contract::allocations() - before, 0U);
}

TEST(WorkerPool, SaysWhetherItsWorkersHaveTheRealTimePriorityThatWasAskedFor) {
    if (processors() == 1) GTEST_SKIP() << "one processor: there is no worker";
    constexpr int asked = 5, no_such = 1000;
    EXPECT_FALSE(WorkerPool(2).real_time());
    EXPECT_FALSE(WorkerPool(2, no_such).real_time());

    WorkerPool pool(2, asked);
    int policy = -1;
    sched_param found{};
    ASSERT_TRUE(meet(pool, [&] { pthread_getschedparam(pthread_self(), &policy, &found); }).met);
    std::printf("SCHED_FIFO %s\n", pool.real_time() ? "granted" : "refused");
    EXPECT_EQ(policy, pool.real_time() ? SCHED_FIFO : SCHED_OTHER);
    EXPECT_EQ(found.sched_priority, pool.real_time() ? asked : 0);
    expect_each_once(pool);
}

}    // namespace
}    // namespace stylet::core
