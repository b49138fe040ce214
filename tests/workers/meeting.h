#pragma once

#include "core/workers/worker_pool.h"

#include <atomic>
#include <chrono>
#include <thread>

namespace stylet::core {

/// How long a test waits for what must come; reached only where it never does.
inline constexpr std::chrono::seconds never{20};

/// Waits until the condition holds; false where it never does.
template <class Condition>
[[nodiscard]] bool comes_true(const Condition& condition) {
    const auto deadline = std::chrono::steady_clock::now() + never;
    while (!condition()) {
        if (std::chrono::steady_clock::now() > deadline) return false;
        std::this_thread::yield();
    }
    return true;
}

/// What a meeting came to.
struct Meeting {
    bool alone = false;    // the pool did this run on one thread, so nobody could meet
    bool met = false;      // a worker took one task while the caller was in the other
};

/// A run of two tasks in which the caller stays until a worker has come to the other; then `worker_stays` runs on the worker.
template <class Stay>
Meeting meet(WorkerPool& pool, const Stay& worker_stays) {
    const auto caller = std::this_thread::get_id();
    const std::int64_t alone_before = pool.runs_alone();
    std::atomic<bool> worker_came{false};
    Meeting meeting;
    pool.each(2, [&](int) {
        if (std::this_thread::get_id() != caller) {
            worker_came = true;
            worker_stays();
            return;
        }
        meeting.alone = pool.runs_alone() > alone_before;
        if (!meeting.alone) meeting.met = comes_true([&] { return worker_came.load(); });
    });
    return meeting;
}

inline Meeting meet(WorkerPool& pool) {
    return meet(pool, [] {});
}

}    // namespace stylet::core
