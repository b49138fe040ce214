#pragma once

#include "core/run/durations.h"
#include "core/run/patch_record.h"
#include "core/run/report.h"
#include "core/run/simulation.h"

#include <vector>

namespace stylet::core {

/// Collects from tick to tick what a report says. All memory is set aside when it is made: it may be filled from the tick's
/// thread.
class Reporter {
public:
    static constexpr std::size_t most_events = 10000;    // further ones are only counted

    Reporter(const Scene& scene, const Cast& cast, std::size_t most_ticks);

    /// After a tick, which took `duration` [µs]. Neither allocates nor locks.
    void take(const Simulation& simulation, double duration);

    /// Once, in the end.
    [[nodiscard]] RunReport finish(const Simulation& simulation);

private:
    void name_events();

    RunReport report_;
    PatchRecord patches_;
    std::vector<Event> events_;
    Durations durations_;    // of the ticks after a warm-up
    std::size_t warm_up_;    // [ticks]
    std::size_t ticks_ = 0;
    bool has_hand_;
};

}    // namespace stylet::core
