#include "core/run/real_time_loop.h"

#include <fmt/format.h>
#include <pthread.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/prctl.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <ctime>
#include <thread>
#include <utility>

namespace stylet::core {

namespace {

constexpr std::int64_t second = 1'000'000'000;    // [ns]
constexpr auto watch_period = std::chrono::milliseconds(50);

// Without a system call: the kernel answers through its shared page.
std::int64_t now() {
    timespec time{};
    clock_gettime(CLOCK_MONOTONIC, &time);
    return time.tv_sec * second + time.tv_nsec;
}

void sleep_until(std::int64_t deadline) {
    const timespec time{.tv_sec = deadline / second, .tv_nsec = deadline % second};
    while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &time, nullptr) == EINTR) {
    }
}

double microseconds(std::int64_t duration) {
    return 1e-3 * static_cast<double>(duration);
}

std::string refused(int error) {
    return fmt::format("not granted ({})", std::strerror(error));
}

std::string ask_for_fifo() {
    const sched_param wanted{.sched_priority = RealTimeLoop::priority};
    const int error = pthread_setschedparam(pthread_self(), SCHED_FIFO, &wanted);
    return error == 0 ? fmt::format("SCHED_FIFO, priority {}", RealTimeLoop::priority) : "SCHED_FIFO " + refused(error);
}

// The stack's pages come now, not in a tick.
void touch_stack() {
    constexpr std::size_t size = 1 << 18, page = 1 << 12;    // [bytes]
    char pages[size];
    for (std::size_t i = 0; i < size; i += page) static_cast<volatile char&>(pages[i]) = 0;
}

}    // namespace

// Once the thread and all that it needs are there: a lock on the future would refuse the stack of the next thread.
void RealTimeLoop::prepare() {
    report_.scheduling = ask_for_fifo();
    prctl(PR_SET_TIMERSLACK, 1UL, 0UL, 0UL, 0UL);    // a thread that is not SCHED_FIFO would wake 50 µs late
    touch_stack();
    report_.memory = mlockall(MCL_CURRENT) == 0 ? "locked" : "lock " + refused(errno);
}

void RealTimeLoop::loop(std::size_t ticks, const Work& work, const std::atomic<bool>& stop) {
    prepare();
    const auto period = static_cast<std::int64_t>(std::llround(period_ * static_cast<double>(second)));
    const std::int64_t start = now();
    std::int64_t deadline = start + period, answered = start, before = start;
    for (std::size_t i = 0; i < ticks && !stop && !ending_; ++i) {
        sleep_until(deadline);
        const std::int64_t woke = now();
        const std::int64_t held = std::max(woke - answered, answered - before);
        work.tick(1e-6 * microseconds(held));
        before = std::exchange(answered, now());
        report_.woke.add(microseconds(woke - deadline));
        report_.answered.add(microseconds(answered - deadline));
        report_.lost_rows += !work.note();
        done_.store(i + 1, std::memory_order_relaxed);
        deadline += period;
        if (const std::int64_t late = now() - deadline; late > 0) {
            const std::int64_t given_up = late / period;
            ++report_.overruns;
            report_.skipped += static_cast<std::size_t>(given_up);
            deadline += given_up * period;
        }
    }
    report_.wall_time = static_cast<double>(now() - start) / static_cast<double>(second);
    while (work.let_go()) sleep_until(deadline += period);
    ended_ = true;
}

RealTimeReport RealTimeLoop::run(std::size_t ticks, const Work& work, const std::function<void(std::size_t done)>& watch,
                                 const std::atomic<bool>& stop) {
    report_ = {};
    done_ = 0;
    ending_ = ended_ = false;
    {
        std::jthread thread([&] { loop(ticks, work, stop); });
        try {
            while (!ended_) {
                std::this_thread::sleep_for(watch_period);
                if (watch) watch(done_.load(std::memory_order_relaxed));
            }
        } catch (...) {
            ending_ = true;
            thread.join();
            munlockall();
            throw;
        }
    }
    munlockall();
    return report_;
}

}    // namespace stylet::core
