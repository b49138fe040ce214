#include "core/run/recorder.h"

#include <stylet/contract/allocations.h>
#include <stylet/error.h>

#include <gtest/gtest.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <csignal>
#include <fstream>
#include <sstream>
#include <thread>

namespace stylet::core {
namespace {

using std::chrono::milliseconds;

const Recorder::Heading heading{.title = "A needle", .scene = "needle.yaml", .hash = "0123456789abcdef"};

/// A folder of the test's own that goes with it.
class Recording : public testing::Test {
protected:
    Recording() : folder_(std::filesystem::path(testing::TempDir()) / ("stylet_recorder_" + std::to_string(getpid()))) {
        std::filesystem::create_directories(folder_);
    }
    ~Recording() override { std::filesystem::remove_all(folder_); }

    [[nodiscard]] std::filesystem::path file(const char* name) const { return folder_ / name; }

    static std::string contents(const std::filesystem::path& path) {
        std::ostringstream text;
        text << std::ifstream(path, std::ios::binary).rdbuf();
        return text.str();
    }
    static std::vector<std::string> lines(const std::filesystem::path& path) {
        std::istringstream text(contents(path));
        std::vector<std::string> found;
        for (std::string line; std::getline(text, line);) found.push_back(line);
        return found;
    }

private:
    std::filesystem::path folder_;
};

Sample sample_at(double time) {
    Sample sample;
    sample.time = time;
    sample.depth = 1.0 / 3.0;
    sample.hand_force = -0.1;
    return sample;
}

void push_patiently(Recorder& recorder, const Sample& sample, std::span<const Event> events) {
    while (!recorder.push(sample, events)) std::this_thread::sleep_for(milliseconds(1));
}

TEST_F(Recording, OpensWithItsHeadingAndTheUnitsOfItsColumns) {
    Recorder recorder(file("a.csv"), heading, columns_of({"depth", "hand_force"}));
    recorder.finish();
    const std::vector<std::string> expected{"# stylet recording 1", "# title: A needle", "# scene: needle.yaml",
                                            "# hash: 0123456789abcdef", "time [s],depth [m],hand_force [N],event"};
    EXPECT_EQ(lines(file("a.csv")), expected);
}

TEST_F(Recording, HasARowForEachTickWithItsEvents) {
    Recorder recorder(file("a.csv"), heading, columns_of({"hand_force"}));
    const std::array events{Event{.name = "punctured"}, Event{.name = "straightened"}};
    ASSERT_TRUE(recorder.push(sample_at(0.001), {}));
    ASSERT_TRUE(recorder.push(sample_at(0.002), std::span(events).first(1)));
    ASSERT_TRUE(recorder.push(sample_at(0.003), events));
    recorder.finish();
    const std::vector<std::string> all = lines(file("a.csv"));
    const std::vector<std::string> rows(all.begin() + 5, all.end());
    const std::vector<std::string> expected{"0.001,-0.1,", "0.002,-0.1,punctured", "0.003,-0.1,punctured; straightened"};
    EXPECT_EQ(rows, expected);
}

TEST_F(Recording, HoldsNoWordsThatAReaderOfCsvWouldTakeForMore) {
    const Recorder::Heading odd{.title = "Two\nlines", .scene = "a\nb.yaml", .hash = "0123456789abcdef"};
    Recorder recorder(file("a.csv"), odd, columns_of({}));
    const std::array events{Event{.name = "slope over 45°, \"bent\"; #1\n"}, Event{.name = "touched"}};
    ASSERT_TRUE(recorder.push(sample_at(0.001), events));
    recorder.finish();
    const std::vector<std::string> expected{"# stylet recording 1",  "# title: Two\\x0alines",
                                            "# scene: a\\x0ab.yaml", "# hash: 0123456789abcdef",
                                            "time [s],event",        "0.001,slope over 45°   bent    1 ; touched"};
    EXPECT_EQ(lines(file("a.csv")), expected);
}

TEST_F(Recording, KeepsEveryBitOfANumber) {
    constexpr double third = 1.0 / 3.0;
    Recorder recorder(file("a.csv"), heading, columns_of({"depth"}));
    ASSERT_TRUE(recorder.push(sample_at(1e-300), {}));
    recorder.finish();
    const std::string row = lines(file("a.csv")).back();
    EXPECT_EQ(std::stod(row), 1e-300);
    EXPECT_EQ(std::stod(row.substr(row.find(',') + 1)), third);
}

TEST_F(Recording, OfTheSameRowsIsTheSameToTheBit) {
    for (const char* name : {"a.csv", "b.csv"}) {
        Recorder recorder(file(name), heading, columns_of({"ledger", "depth"}));
        for (int i = 0; i < 3000; ++i) push_patiently(recorder, sample_at(0.001 * i), {});
        recorder.finish();
    }
    EXPECT_EQ(contents(file("a.csv")), contents(file("b.csv")));
}

TEST_F(Recording, OfAHastyRunLosesNoRow) {
    constexpr int rows = 20000;    // five times what the ring holds
    {
        Recorder recorder(file("a.csv"), heading, columns_of({}));
        for (int i = 0; i < rows; ++i) push_patiently(recorder, sample_at(i), {});
    }
    const std::vector<std::string> all = lines(file("a.csv"));
    ASSERT_EQ(all.size(), 5u + rows);
    for (int i = 0; i < rows; ++i) ASSERT_EQ(all[5 + i], std::to_string(i) + ",");
}

TEST_F(Recording, ThatCannotBeWrittenIsAnError) {
    const std::filesystem::path nowhere = file("no such folder") / "a.csv";
    try {
        const Recorder recorder(nowhere, heading, columns_of({}));
        FAIL() << "wrote into a folder that does not exist";
    } catch (const Error& error) {
        EXPECT_EQ(error.what(), "the recording '" + nowhere.string() + "' cannot be written");
    }
}

TEST_F(Recording, OnAFullDiskIsAnErrorAtItsEnd) {
    Recorder recorder("/dev/full", heading, columns_of({}));
    (void)recorder.push(sample_at(0.0), {});
    EXPECT_THROW(recorder.finish(), Error);
}

/// Seconds on a clock that parent and child share.
double now() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// The child's whole life: a row for each millisecond, and beside it, in shared memory, when it pushed the last.
[[noreturn]] void record_until_killed(const std::filesystem::path& path, std::atomic<double>& last_pushed) {
    Recorder recorder(path, heading, columns_of({"ledger"}));
    for (;;) {
        const double time = now();
        if (recorder.push(sample_at(time), {})) last_pushed = time;
        std::this_thread::sleep_for(milliseconds(1));
    }
}

/// When the last row that ends with a line feed was pushed.
double last_whole_row(const std::string& text) {
    const std::size_t end = text.rfind('\n');
    const std::size_t begin = text.rfind('\n', end - 1) + 1;
    return std::stod(text.substr(begin, end - begin));
}

TEST_F(Recording, OfAKilledProcessLacksAtMostItsLastTenthOfASecond) {
    constexpr double promised = 0.1;    // [s]
    void* const shared = mmap(nullptr, sizeof(std::atomic<double>), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    ASSERT_NE(shared, MAP_FAILED);
    auto& last_pushed = *new (shared) std::atomic<double>(0.0);
    for (const int life : {317, 444, 503, 571, 639}) {    // [ms] at no particular moment of the recorder's own rhythm
        const std::filesystem::path path = file("killed.csv");
        const pid_t child = fork();
        ASSERT_GE(child, 0);
        if (child == 0) record_until_killed(path, last_pushed);
        std::this_thread::sleep_for(milliseconds(life));
        ASSERT_EQ(kill(child, SIGKILL), 0);
        ASSERT_EQ(waitpid(child, nullptr, 0), child);
        EXPECT_LE(last_pushed - last_whole_row(contents(path)), promised) << "killed after " << life << " ms";
    }
    munmap(shared, sizeof(std::atomic<double>));
}

}    // namespace
}    // namespace stylet::core
