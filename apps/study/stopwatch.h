#pragma once

#include <algorithm>
#include <ctime>
#include <fstream>

namespace stylet::study {

/// How long something took, and how much of it the machine did other work.
class Stopwatch {
public:
    Stopwatch() { start(); }
    void start() {
        wall_ = now(CLOCK_MONOTONIC);
        processor_ = now(CLOCK_PROCESS_CPUTIME_ID);
        queued_ = queued();
    }

    [[nodiscard]] double wall() const { return now(CLOCK_MONOTONIC) - wall_; }    // [s]

    /// The share of the time in which this thread was kept from running, or none of ours ran: somebody else did. With helpers the
    /// processors' time of all of them says little, but this thread's turns say what the work that it shares met.
    [[nodiscard]] double waited() const {
        const double passed = wall(), ran = now(CLOCK_PROCESS_CPUTIME_ID) - processor_;
        if (!(passed > 0.0)) return 0.0;
        return std::clamp(std::max(1.0 - ran / passed, (queued() - queued_) / passed), 0.0, 1.0);
    }

private:
    static double now(clockid_t clock) {
        timespec time{};
        clock_gettime(clock, &time);
        return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
    }

    /// [s] in which this thread could have run, and had to wait for its turn; 0 where the system doesn't say.
    static double queued() {
        std::ifstream statistics("/proc/thread-self/schedstat");
        double ran = 0.0, waited = 0.0;    // [ns]
        return statistics >> ran >> waited ? 1e-9 * waited : 0.0;
    }

    double wall_ = 0.0, processor_ = 0.0, queued_ = 0.0;    // [s]
};

}    // namespace stylet::study
