#pragma once

#include <stylet/workers.h>

#include <atomic>
#include <cstdint>
#include <optional>
#include <thread>
#include <vector>

namespace stylet::core {

/// How many processors the calling thread, and those it makes, may use; at least 1.
[[nodiscard]] int processors();

/// Threads of core's own that help whoever calls each().
///
/// The caller works too, and waits only for tasks that another thread has begun, never for a thread that has yet to come. An idle
/// worker looks for the next run for 20 µs, then sleeps. On a busy machine a worker may lose its processor in the middle of a
/// task: where the caller has waited longer than it would have taken to do the others' tasks itself, the pool has lost by
/// sharing, and works on one thread for a while before it shares again: for a single run at first, each time for twice as many,
/// at most 1024, and for a single one again after 1000 shared runs in a row without loss.
class WorkerPool final : public Workers {
public:
    /// Makes `threads` − 1 threads, fewer where the system allows no more, none where there is only one processor to use. With
    /// `real_time_priority` (1 to 99) they ask for SCHED_FIFO, as the thread that calls each() should have done too; without, or
    /// where it is refused, they keep the scheduling class of the thread that makes the pool.
    explicit WorkerPool(int threads, std::optional<int> real_time_priority = std::nullopt);

    /// No run may be under way.
    ~WorkerPool() override;

    [[nodiscard]] int count() const override { return static_cast<int>(threads_.size()) + 1; }

    /// True where a real-time priority was asked for and no worker was refused it.
    [[nodiscard]] bool real_time() const { return real_time_; }

    /// How often the pool lost by sharing. Readable from any thread, at any time.
    [[nodiscard]] std::int64_t fallbacks() const { return fallbacks_; }

    /// How many runs one thread did alone because of it, one under way counted. Readable from any thread, at any time.
    [[nodiscard]] std::int64_t runs_alone() const { return runs_alone_; }

private:
    void run(int tasks, Call call, void* context) noexcept override;
    void share(int tasks, Call call, void* context);
    int take_part();
    void wait_for_others();
    void judge(bool late);

    void serve();
    [[nodiscard]] unsigned next_run(unsigned last);

    // The run under way: written by the caller while there is nothing to claim, read by those who have claimed.
    Call call_ = nullptr;
    void* context_ = nullptr;

    // Apart from each other, or the threads would pass one cache line to and fro.
    alignas(64) std::atomic<int> unclaimed_{0};     // tasks that nobody has begun; negative where threads found none
    alignas(64) std::atomic<int> unfinished_{0};    // tasks; the caller sleeps on it
    alignas(64) std::atomic<unsigned> runs_{0};     // shared so far; idle workers sleep on it
    std::atomic<bool> closing_{false};

    alignas(64) std::atomic<bool> taken_{false};    // by a caller; guards what follows and the run
    int alone_ = 0;                                 // runs that are still to be done on one thread
    int back_off_ = 1;                              // runs that the next fallback lasts
    int timely_ = 0;                                // shared runs since the last late one
    std::atomic<std::int64_t> fallbacks_{0};
    std::atomic<std::int64_t> runs_alone_{0};

    bool real_time_ = false;
    std::vector<std::thread> threads_;
};

}    // namespace stylet::core
