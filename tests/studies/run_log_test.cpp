// What a study remembers of an earlier run of itself.
#include "apps/study/run_log.h"

#include "apps/study/timing.h"

#include <stylet/error.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>

namespace stylet::study {
namespace {

class RunLogTest : public testing::Test {
protected:
    RunLogTest() : file_(std::filesystem::path(testing::TempDir()) / "stylet_run_log_test.jsonl") {
        std::filesystem::remove(file_);
    }
    ~RunLogTest() override { std::filesystem::remove(file_); }

    void write(const std::string& key, const Outcome& outcome) const { RunLog(file_, false).add(key, "name", outcome); }

    std::filesystem::path file_;
};

TEST_F(RunLogTest, GivesBackEveryDigit) {
    const Outcome outcome{.x = {0.1, 1.0 / 3.0},
                          .y = {1e-300, std::numeric_limits<double>::infinity()},
                          .remarks = {"a \"remark\""},
                          .timing = Timing{.median = 1.0 / 7.0, .p99 = 2.0, .worst = 3.0, .mean = 1.0 / 9.0, .waited = 0.01}};
    write("key", outcome);
    const RunLog log(file_, false);
    const Outcome* found = log.find("key");
    ASSERT_NE(found, nullptr);
    EXPECT_EQ(found->x, outcome.x);
    EXPECT_EQ(found->y.front(), outcome.y.front());
    EXPECT_FALSE(std::isfinite(found->y.back()));
    EXPECT_EQ(found->remarks, outcome.remarks);
    EXPECT_EQ(found->timing->median, outcome.timing->median);
    EXPECT_EQ(found->timing->mean, outcome.timing->mean);
    EXPECT_EQ(log.find("another"), nullptr);
}

TEST_F(RunLogTest, DoesNotTrustATimeTakenOnABusyMachine) {
    write("key", {.x = {}, .y = {1.0}, .timing = Timing{.median = 1.0, .contended = true}});
    EXPECT_EQ(RunLog(file_, false).find("key"), nullptr);
    write("key", {.x = {}, .y = {1.0}, .timing = Timing{.median = 1.0}});
    EXPECT_NE(RunLog(file_, false).find("key"), nullptr) << "the later line counts";
}

TEST_F(RunLogTest, PassesOverWhatIsNoLineOfItsOwn) {
    std::ofstream(file_) << "{\"key\": \"torn\", \"x\": [1, 2\nnonsense\n{\"key\": 3}\n{\"other\": 1}";
    write("key", {.x = {}, .y = {1.0}});
    const RunLog log(file_, false);
    EXPECT_NE(log.find("key"), nullptr) << "the line before it had no end";
    EXPECT_EQ(log.find("torn"), nullptr);
}

TEST_F(RunLogTest, IsOneStudysAtATime) {
    write("key", {.x = {}, .y = {1.0}});
    const RunLog first(file_, false);
    try {
        const RunLog second(file_, true);
        FAIL() << "two at once";
    } catch (const Error& error) {
        EXPECT_THAT(error.what(),
                    testing::EndsWith("stylet_run_log_test.jsonl: found another study at work on it, wanted one at a "
                                      "time: wait for it, or name another folder"));
    }
    EXPECT_GT(std::filesystem::file_size(file_), 0u) << "what the first has is not forgotten";
}

TEST_F(RunLogTest, ForgetsWhereItShall) {
    write("key", {.x = {}, .y = {1.0}});
    EXPECT_EQ(RunLog(file_, true).find("key"), nullptr);
    EXPECT_EQ(std::filesystem::file_size(file_), 0u);
}

TEST(TimingOfRepetitions, TakesTheQuietest) {
    const auto timing = [](double median, double waited) {
        return Timing{.median = median, .p99 = 2.0 * median, .worst = 3.0 * median, .waited = waited};
    };
    const Timing two = of_repetitions({timing(9.0, 0.5), timing(1.0, 0.0), timing(2.0, 0.01)}, 2);
    EXPECT_EQ(two.median, 1.5);
    EXPECT_EQ(two.p99, 3.0);
    EXPECT_EQ(two.worst, 6.0);
    EXPECT_FALSE(two.contended);
    EXPECT_TRUE(of_repetitions({timing(9.0, 0.5), timing(1.0, 0.0)}, 2).contended) << "one that counts had to wait";
}

TEST(TimingOfCases, IsContendedWhereMostOfThemAre) {
    const Timing quiet{.median = 1.0}, busy{.median = 5.0, .waited = 0.6, .contended = true};
    EXPECT_FALSE(of_cases({quiet, quiet, busy}).contended);
    EXPECT_EQ(of_cases({quiet, quiet, busy}).median, 1.0);
    EXPECT_EQ(of_cases({quiet, quiet, busy}).waited, 0.0);
    EXPECT_TRUE(of_cases({quiet, busy, busy}).contended);
}

}    // namespace
}    // namespace stylet::study
