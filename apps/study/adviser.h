// Measures a scene and its neighbours, to advise on it.
#pragma once

#include "apps/study/advice.h"
#include "apps/study/run_study.h"

#include <atomic>
#include <functional>

namespace stylet::study {

constexpr double longest_setting = 15.0;      // [s] that a run may take
constexpr double longest_reference = 45.0;    // [s] the same of the scene itself, and of the reference that was looked for

struct Request {
    std::filesystem::path scene;
    std::vector<core::Override> changes;                     // of the scene, before all
    std::optional<double> budget;                            // [s] for a tick; left out, the scene's own period
    double error;                                            // relative, at most
    std::optional<std::vector<core::Override>> reference;    // on top of those; left out: it is looked for
    int threads;
    core::PluginFolders folders;
};

/// Runs every neighbour once or, where that is quick, several times, one after the other. Compared is hand_force over time, of a
/// tissue alone patch_displacement, of a needle that nobody holds deflection. The reference, where none is asked for, is the
/// costliest combination of models with all its numbers one step finer, but for the rate; where that is not done in the time
/// there is for it, the combination as it is. What would take too long is given up and told of. Nothing where it was stopped.
/// Throws core::SceneErrors where the scene or the reference is wrong, Error where there is nothing to compare.
[[nodiscard]] std::optional<Advice> advise(const Request& request, const std::atomic<bool>& stop,
                                           const std::function<void(const Progress&)>& progress);

}    // namespace stylet::study
