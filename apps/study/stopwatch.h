#pragma once

#include <ctime>

namespace stylet::study {

/// How long something took, and how much of it this process had a processor for.
class Stopwatch {
public:
    Stopwatch() { start(); }
    void start() {
        wall_ = now(CLOCK_MONOTONIC);
        processor_ = now(CLOCK_PROCESS_CPUTIME_ID);
    }

    [[nodiscard]] double wall() const { return now(CLOCK_MONOTONIC) - wall_; }    // [s]

    /// The share of the time in which none of our threads ran: somebody else did, or the disk was waited for.
    [[nodiscard]] double waited() const {
        const double passed = wall(), ran = now(CLOCK_PROCESS_CPUTIME_ID) - processor_;
        return passed > 0.0 && ran < passed ? 1.0 - ran / passed : 0.0;
    }

private:
    static double now(clockid_t clock) {
        timespec time{};
        clock_gettime(clock, &time);
        return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
    }

    double wall_ = 0.0, processor_ = 0.0;    // [s]
};

}    // namespace stylet::study
