#include "core/workers/worker_pool.h"

#include <pthread.h>
#include <sched.h>

#include <algorithm>
#include <chrono>
#include <system_error>

namespace stylet::core {

namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::microseconds;

// An idle worker looks about for this long before it sleeps: longer than the pauses between the runs of one tick, and too short
// to matter to anybody else (2 % of one processor at 1 kHz).
constexpr microseconds alertness{20};

// The caller looks for the others' last tasks for this long before it sleeps, and calls no wait below it late: about what it
// takes a thread to fall asleep and be woken.
constexpr microseconds grace{50};

constexpr int longest_back_off = 1024;    // [runs] a second at 1 kHz
constexpr int forgiving = 1000;           // [runs] so many timely ones in a row, and a fallback is a single run again

bool make_real_time(std::thread& thread, int priority) {
    sched_param wanted{};
    wanted.sched_priority = priority;
    return pthread_setschedparam(thread.native_handle(), SCHED_FIFO, &wanted) == 0;
}

}    // namespace

int processors() {
    cpu_set_t usable;
    return sched_getaffinity(0, sizeof(usable), &usable) == 0 ? std::max(1, CPU_COUNT(&usable)) : 1;
}

WorkerPool::WorkerPool(int threads, std::optional<int> real_time_priority) : real_time_(real_time_priority.has_value()) {
    if (threads <= 1 || processors() == 1) return;
    threads_.reserve(static_cast<std::size_t>(threads - 1));
    try {
        while (count() < threads) threads_.emplace_back([this] { serve(); });
    } catch (const std::system_error&) {
        // As many as there are must do: count() tells.
    }
    for (std::thread& thread : threads_) real_time_ = real_time_ && make_real_time(thread, *real_time_priority);
}

WorkerPool::~WorkerPool() {
    closing_ = true;
    ++runs_;
    runs_.notify_all();
    for (std::thread& thread : threads_) thread.join();
}

void WorkerPool::run(int tasks, Call call, void* context) noexcept {
    const bool mine = tasks > 1 && !threads_.empty() && !taken_.exchange(true, std::memory_order_acquire);
    if (mine && alone_ == 0) {
        share(tasks, call, context);
    } else {
        if (mine) {
            --alone_;
            ++runs_alone_;
        }
        for (int i = 0; i < tasks; ++i) call(context, i);
    }
    if (mine) taken_.store(false, std::memory_order_release);
}

void WorkerPool::share(int tasks, Call call, void* context) {
    call_ = call;
    context_ = context;
    unfinished_.store(tasks, std::memory_order_relaxed);
    const int own = tasks - 1;    // no other thread can have this one
    unclaimed_.store(own, std::memory_order_release);
    ++runs_;
    runs_.notify_all();    // a system call only where a thread sleeps

    const auto start = Clock::now();
    call(context, own);
    const int done = 1 + take_part();
    unfinished_ -= done;
    const auto end = Clock::now();
    if (done == tasks) return;    // nobody else came: that says nothing about how timely they would have been
    wait_for_others();
    judge(Clock::now() - end > grace + (end - start) / done * (tasks - done));
}

// Claims and does tasks until there is nothing left to claim; returns how many.
//
// A thread knows nothing of a run until it has claimed: whatever it last saw, a claim that brings unclaimed_ down from above zero
// is a task of the run that is under way at that instant, and that run, with its call_ and context_, can't end before
// the claimer has finished. So a worker that slept through any number of runs does no harm, and no run needs a number here.
int WorkerPool::take_part() {
    int done = 0;
    for (int left; (left = unclaimed_.fetch_sub(1, std::memory_order_acquire)) > 0; ++done) call_(context_, left - 1);
    return done;
}

// Sleeps in the end: to spin could keep the late thread from the very processor that it waits for, under SCHED_FIFO for ever.
void WorkerPool::wait_for_others() {
    const auto tired = Clock::now() + grace;
    while (unfinished_ > 0 && Clock::now() < tired) continue;
    for (int left; (left = unfinished_) > 0;) unfinished_.wait(left);
}

void WorkerPool::judge(bool late) {
    if (late) {
        ++fallbacks_;
        alone_ = back_off_;
        back_off_ = std::min(2 * back_off_, longest_back_off);
        timely_ = 0;
    } else if (++timely_ == forgiving) {
        back_off_ = 1;
        timely_ = 0;
    }
}

void WorkerPool::serve() {
    for (unsigned last = 0; !closing_; last = next_run(last)) {
        const int done = take_part();
        if (done > 0 && (unfinished_ -= done) == 0) unfinished_.notify_one();
    }
}

// The number of a run after `last`, when there is one.
unsigned WorkerPool::next_run(unsigned last) {
    const auto tired = Clock::now() + alertness;
    while (runs_ == last && Clock::now() < tired) continue;
    runs_.wait(last);
    return runs_;
}

}    // namespace stylet::core
