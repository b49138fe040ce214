// One thing to measure: a scene, once or several times over.
#pragma once

#include "apps/study/outcome.h"
#include "core/loading/plugin_folders.h"

#include <atomic>
#include <functional>

namespace stylet::study {

struct Job {
    core::Scene scene;
    std::string name;    // "rod, 41 nodes, case 3", as a progress bar shows it
    std::string key;     // the same where the same would be measured with the same libraries: SHA-1
    Measure measure;
    Timed timed;
    int repetitions, threads;
};

/// Identifies what a job measures: its scene, its measure, what is timed how often on which processor, and the bytes of every
/// library that takes part.
[[nodiscard]] std::string key_of(const Job& job, const core::PluginFolders& folders, const std::string& processor);

/// Measures it. `progress` is called now and then with the share that is done. Where the scene's models refuse, or the run ends
/// in a fault, the outcome says so. A stopped job has no outcome.
[[nodiscard]] std::optional<Outcome> measure(const Job& job, const core::PluginFolders& folders, const std::atomic<bool>& stop,
                                             const std::function<void(double)>& progress);

}    // namespace stylet::study
