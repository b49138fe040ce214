// A pool that loses by sharing stops to share for a while.

#include "tests/workers/meeting.h"

#include <gtest/gtest.h>

#include <vector>

namespace stylet::core {
namespace {

// Stays on the worker much longer than the caller has been in its own task, which is how long that waited for the worker. That is
// late, unless the caller itself loses its processor for as long.
Meeting meet_late(WorkerPool& pool) {
    const auto start = std::chrono::steady_clock::now();
    return meet(pool, [start] {
        std::this_thread::sleep_for(std::chrono::milliseconds(2) + 10 * (std::chrono::steady_clock::now() - start));
    });
}

// Makes workers late until the pool has fallen back `times` times; returns how many runs it had done alone before each fallback.
std::vector<std::int64_t> fall_back(WorkerPool& pool, int times) {
    constexpr int most_meetings = 1000, most_runs = 100'000;    // where the pool never falls back, or does so for ever
    std::vector<std::int64_t> alone;
    for (int run = 0, meetings = 0; run < most_runs && meetings < most_meetings && std::ssize(alone) < times; ++run) {
        const std::int64_t alone_before = pool.runs_alone(), fallbacks_before = pool.fallbacks();
        if (meet_late(pool).met) ++meetings;
        if (pool.fallbacks() > fallbacks_before) alone.push_back(alone_before);
    }
    return alone;
}

class Fallback : public testing::Test {
protected:
    void SetUp() override {
        if (processors() == 1) GTEST_SKIP() << "one processor: there is no worker";
    }

    WorkerPool pool_{2};
};

TEST_F(Fallback, DoesEveryTaskInTheCallersThread) {
    fall_back(pool_, 4);
    const auto caller = std::this_thread::get_id();
    constexpr int runs = 8;    // 1, 2, 4, and now 8
    for (int run = 0; run < runs; ++run) {
        pool_.each(16, [&](int) { EXPECT_EQ(std::this_thread::get_id(), caller); });
    }
    EXPECT_EQ(pool_.runs_alone(), 1 + 2 + 4 + 8);
}

TEST_F(Fallback, LastsTwiceAsLongEachTime) {
    const std::vector<std::int64_t> before_each{0, 1, 1 + 2, 1 + 2 + 4, 1 + 2 + 4 + 8, 1 + 2 + 4 + 8 + 16};
    EXPECT_EQ(fall_back(pool_, 6), before_each);
    EXPECT_EQ(pool_.fallbacks(), 6);
}

TEST_F(Fallback, LastsNoLongerThan1024Runs) {
    constexpr int doublings = 10, longest = 1024;
    const std::vector<std::int64_t> alone = fall_back(pool_, doublings + 4);
    ASSERT_EQ(alone.size(), doublings + 4U);
    for (std::size_t i = doublings + 1; i < alone.size(); ++i) EXPECT_EQ(alone[i] - alone[i - 1], longest);
}

TEST_F(Fallback, EndsByItself) {
    fall_back(pool_, 3);
    for (int run = 0; run < 4; ++run) EXPECT_TRUE(meet(pool_).alone);
    EXPECT_TRUE(meet(pool_).met);
}

// A busy machine makes workers late of itself, and the count begins anew.
TEST_F(Fallback, IsASingleRunAgainAfter1000TimelyOnes) {
    constexpr int timely = 1000, tries = 50;
    fall_back(pool_, 4);
    std::int64_t fallbacks = 0;
    for (int i = 0; i < tries && fallbacks != pool_.fallbacks(); ++i) {
        fallbacks = pool_.fallbacks();
        int met = 0;
        for (int run = 0; run < 4 * timely && met < timely; ++run) met += meet(pool_).met;
    }
    ASSERT_EQ(fallbacks, pool_.fallbacks()) << "workers were late of themselves, time and again";
    fall_back(pool_, 1);
    EXPECT_TRUE(meet(pool_).alone);
    EXPECT_TRUE(meet(pool_).met);
}

TEST_F(Fallback, IsNotCalledForByRunsThatNobodyElseCameTo) {
    for (int run = 0; run < 1000; ++run) pool_.each(1, [](int) {});
    EXPECT_EQ(pool_.fallbacks(), 0);
    EXPECT_EQ(pool_.runs_alone(), 0);
}

}    // namespace
}    // namespace stylet::core
