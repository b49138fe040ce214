#pragma once

#include "apps/study/result.h"
#include "core/loading/plugin_folders.h"

#include <atomic>
#include <functional>

namespace stylet::study {

struct Progress {
    std::size_t done, all;                 // of what is to be measured
    double share;                          // of all of it, from 0 to 1
    std::optional<double> seconds_left;    // as far as what was measured so far tells
    std::string name;                      // of what is being measured
};

struct Options {
    core::PluginFolders folders;
    std::filesystem::path log{};    // where outcomes are kept from one call to the next; empty: nowhere
    bool again = false;             // what the log has is forgotten
    std::function<void(const Progress&)> progress{};
    const std::atomic<bool>* stop = nullptr;
};

/// Runs every setting in every case, and the reference, and compares. What the log knows is not run again. Where nothing is
/// timed, as many at once as there are processors; else one after the other. Throws core::SceneErrors with all that is wrong with
/// any of its scenes, before anything is run; Error where the log cannot be written.
[[nodiscard]] Result run_study(const Study& study, const Options& options);

}    // namespace stylet::study
