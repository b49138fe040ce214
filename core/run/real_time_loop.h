#pragma once

#include "core/run/latency.h"

#include <atomic>
#include <cstddef>
#include <functional>
#include <string>

namespace stylet::core {

/// How a real-time run went.
struct RealTimeReport {
    std::string scheduling;       // what the system granted: "SCHED_FIFO, priority 80", or why not
    std::string memory;           // "locked", or why not
    std::size_t overruns = 0;     // ticks that ended after the next should have begun
    std::size_t skipped = 0;      // periods that were given up because of them
    std::size_t lost_rows = 0;    // of the recording, because its ring was full
    double wall_time = 0.0;       // [s]
    Latency woke;                 // after the deadline
    Latency answered;             // from the deadline until the device was written to
};

/// Calls a tick at absolute deadlines, on a thread of its own: SCHED_FIFO and all memory locked where the system allows it.
///
/// The next deadline is one period after the last, whenever the tick began: nothing drifts. A tick that takes longer than its
/// period is an overrun; the deadlines that it has missed are given up, so that no burst of ticks follows: the simulation then
/// falls behind the wall clock by that much. From waking up until the tick has returned, the thread makes no system call of its
/// own.
class RealTimeLoop {
public:
    static constexpr int priority = 80;    // above what serves files and networks, below the kernel's own watchdogs

    /// `period` [s].
    explicit RealTimeLoop(double period) : period_(period) {}

    /// What the thread does; nothing of it may throw.
    struct Work {
        std::function<void(double held)> tick;    // up to the device; for how long it held the last force, or the one before [s]
        std::function<bool()> note;               // what is left to do then; false where a row of the recording is lost
        std::function<bool()> let_go;             // after the last: a tick's worth of fading out; true while there is more
    };

    /// Works `ticks` times or until `stop` becomes true, then lets go. `watch` is called from the calling thread meanwhile, some
    /// twenty times a second, with the number of ticks done; it may be empty, and may throw: the loop then lets go first.
    RealTimeReport run(std::size_t ticks, const Work& work, const std::function<void(std::size_t done)>& watch,
                       const std::atomic<bool>& stop);

private:
    void loop(std::size_t ticks, const Work& work, const std::atomic<bool>& stop);
    void prepare();

    double period_;    // [s]
    RealTimeReport report_;
    std::atomic<std::size_t> done_{0};
    std::atomic<bool> ending_{false};    // the watch threw
    std::atomic<bool> ended_{false};
};

}    // namespace stylet::core
