// A scene from its first tick to its last.
#pragma once

#include "core/loading/plugin_folders.h"
#include "core/run/report.h"
#include "core/scene/scene.h"

#include <atomic>
#include <filesystem>
#include <functional>
#include <optional>

namespace stylet::core {

class Simulation;

struct RunOptions {
    std::optional<std::filesystem::path> recording{};    // CSV to write
    std::function<void(double fraction)> progress{};     // called now and then, from 0 to 1; may be empty

    /// Called with the simulation as it begins and after every tick. The virtual clock waits for it; a real-time run has no place
    /// for it. May be empty, and may throw: the run then ends with what it threw.
    std::function<void(const Simulation&)> observe{};

    int threads = 1;                            // that bodies may borrow, the tick's own counted
    const std::atomic<bool>* stop = nullptr;    // once it is true the run ends with the tick in hand
};

/// Loads the scene's cast and runs it to its end as fast as it goes: time is the scene's own. Throws SceneErrors where the cast
/// is refused, Error where the recording cannot be written.
[[nodiscard]] RunReport run(const Scene& scene, const PluginFolders& folders, const RunOptions& options);

/// The same, each tick at its own moment of the wall clock (RealTimeLoop); `observe` is not asked.
[[nodiscard]] RunReport run_in_real_time(const Scene& scene, const PluginFolders& folders, const RunOptions& options);

}    // namespace stylet::core
