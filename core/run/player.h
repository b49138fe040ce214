#pragma once

#include "core/run/recorder.h"
#include "core/run/reporter.h"
#include "core/run/simulation.h"

#include <filesystem>
#include <optional>

namespace stylet::core {

/// A simulation with its report and its recording: what either clock plays, one step for each tick.
class Player {
public:
    /// `recording` is the CSV to write, if any. Throws Error where it cannot be written.
    Player(const Scene& scene, const Cast& cast, std::size_t most_ticks, const std::optional<std::filesystem::path>& recording);

    /// One tick, up to the device, which has held the last force for `held` [s]. Neither allocates nor locks nor calls the
    /// system.
    void tick(double held);

    /// Instead of a tick, once the scene is over: takes the force from the hand. True while there is some left.
    [[nodiscard]] bool let_go() { return simulation_.let_go(); }

    /// What is left to do after it: the report and the recording. False where the recorder's ring is full; the row may then be
    /// tried again, or given up. Neither allocates nor locks nor calls the system.
    [[nodiscard]] bool note();

    /// Waits until the recording is written. Throws Error where the disk was full.
    [[nodiscard]] RunReport finish();

    [[nodiscard]] const Simulation& simulation() const { return simulation_; }

private:
    Simulation simulation_;
    Reporter reporter_;
    std::optional<Recorder> recorder_;
    double duration_ = 0.0;    // [µs] of the last tick
    bool reported_ = true;
};

}    // namespace stylet::core
