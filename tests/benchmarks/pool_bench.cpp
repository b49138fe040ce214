// What sharing a loop costs and what it gives, also when somebody else wants a processor. Rows that compare are run by turns, so
// that the machine's moods fall on all; the ratios are to the first, of the medians and of the whole time. Another machine, or
// another minute, has other times.

#include "core/workers/worker_pool.h"

#include <fmt/format.h>
#include <pthread.h>
#include <sched.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <functional>
#include <numeric>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace {

using namespace stylet::core;
using Clock = std::chrono::steady_clock;
using std::chrono::microseconds;

constexpr int tasks = 16;
constexpr double work = 300.0;            // [µs] of one run on one thread
constexpr microseconds tick{1000};        // one run in each, where they are paced
constexpr int batches = 6, runs = 500;    // per row; the first batch is the warm-up
constexpr int priority = 20;              // where SCHED_FIFO is asked for

double since(Clock::time_point start) {    // [µs]
    return std::chrono::duration<double, std::micro>(Clock::now() - start).count();
}

/// Another process that takes all of a processor that it can get, while this object lives.
class BusyNeighbour {
public:
    BusyNeighbour() : process_(fork()) {
        if (process_ != 0) return;
        prctl(PR_SET_PDEATHSIG, SIGKILL);
        for (volatile bool forever = true; forever;) continue;
    }
    ~BusyNeighbour() {
        kill(process_, SIGKILL);
        waitpid(process_, nullptr, 0);
    }
    BusyNeighbour(const BusyNeighbour&) = delete;
    BusyNeighbour& operator=(const BusyNeighbour&) = delete;

private:
    pid_t process_;
};

// Newton's square root again and again: a chain of divisions that touches no memory.
double grind(int rounds, double number) {
    double root = 1.0;
    for (int i = 0; i < rounds; ++i) root = 0.5 * (root + number / root);
    return root;
}

// How many rounds make a task of one sixteenth of the work.
int rounds_per_task() {
    constexpr int trial = 100'000;
    double best = 1e9, sum = 0.0;    // [µs]
    for (int i = 0; i < 20; ++i) {
        const auto start = Clock::now();
        sum += grind(trial, 2.0 + i);
        best = std::min(best, since(start));
    }
    return sum > 0.0 ? static_cast<int>(trial * work / tasks / best) : 0;
}

/// A way to share: how many threads, and whether they and the caller ask for SCHED_FIFO.
struct Way {
    std::string name;
    int threads;
    std::optional<int> priority;
};

/// What each run of it took.
struct Row {
    Way way;
    std::vector<double> times;    // [µs]
    std::int64_t fallbacks = 0, runs_alone = 0;
    bool refused = false;    // the priority that it asked for

    [[nodiscard]] double total() const { return std::accumulate(times.begin(), times.end(), 0.0); }
    [[nodiscard]] double at(double share) const {    // of the times in order
        return times[static_cast<std::size_t>(share * static_cast<double>(times.size() - 1))];
    }
};

/// What is run: `rounds` per task; one run per tick, as a haptic loop does, or one after the other.
struct Load {
    std::string name;
    int rounds;
    bool paced;
};

void run_batch(Row& row, const Load& load) {
    WorkerPool pool(row.way.threads, row.way.priority);
    if (row.way.priority) {
        const sched_param wanted{*row.way.priority};
        row.refused = pthread_setschedparam(pthread_self(), SCHED_FIFO, &wanted) != 0 || !pool.real_time();
    }
    double results[tasks] = {};
    auto next = Clock::now();
    for (int i = 0; i < runs; ++i) {
        if (load.paced) std::this_thread::sleep_until(next += tick);
        const auto start = Clock::now();
        pool.each(tasks, [&](int task) { results[task] += grind(load.rounds, 1.0 + task); });
        row.times.push_back(since(start));
    }
    row.fallbacks += pool.fallbacks();
    row.runs_alone += pool.runs_alone();
}

// Each batch has a thread of its own, which takes its priority with it when it goes.
void compare(const Load& load) {
    std::vector<Row> rows;
    for (const Way& way : {Way{"1 thread", 1, {}}, Way{"2 threads", 2, {}}, Way{"2 threads, SCHED_FIFO", 2, priority}}) {
        rows.push_back({.way = way, .times = {}});
    }
    for (int batch = 0; batch < batches; ++batch) {
        for (Row& row : rows) {
            if (batch == 1) row = {.way = row.way, .times = {}};    // the first was the warm-up
            std::thread(run_batch, std::ref(row), load).join();
        }
    }
    fmt::print("{:<48} {:>8} {:>8} {:>8} {:>6} {:>6} {:>9} {:>10}\n", load.name, "median", "p99", "worst", "median", "whole",
               "fell back", "runs alone");
    const double first_total = rows.front().total();
    for (Row& row : rows) {
        std::sort(row.times.begin(), row.times.end());
        fmt::print("  {:<46} {:>8.2f} {:>8.2f} {:>8.2f} {:>6.2f} {:>6.2f} {:>9} {:>10}\n",
                   row.way.name + (row.refused ? " (refused)" : ""), row.at(0.5), row.at(0.99), row.at(1.0),
                   row.at(0.5) / rows.front().at(0.5), row.total() / first_total, row.fallbacks, row.runs_alone);
    }
    fmt::print("\n");
    std::fflush(stdout);
}

}    // namespace

int main() {
    const int rounds = rounds_per_task();
    fmt::print("core::WorkerPool on {} processors: one each() of {} tasks, times in µs, {} runs per row\n\n", processors(), tasks,
               (batches - 1) * runs);
    compare({"empty tasks, one run after the other", 0, false});
    compare({"empty tasks, 1000 runs a second", 0, true});
    compare({"300 µs of work, one run after the other", rounds, false});
    compare({"300 µs of work, 1000 runs a second", rounds, true});
    const BusyNeighbour neighbour;
    compare({"beside a busy process, one run after the other", rounds, false});
    compare({"beside a busy process, 1000 runs a second", rounds, true});
}
