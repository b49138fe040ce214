// Measures a scene and its neighbours, to advise on it.
#pragma once

#include "apps/study/advice.h"
#include "apps/study/run_study.h"

#include <atomic>
#include <functional>

namespace stylet::study {

struct Request {
    std::filesystem::path scene;
    std::vector<core::Override> changes;    // of the scene, before all
    Wish wish;
    std::optional<std::vector<core::Override>> reference;    // on top of those; left out: it is looked for
    int threads;
    core::PluginFolders folders;
};

/// Runs every neighbour once or, where that is quick, several times, one after the other. Compared is hand_force over time, of a
/// tissue alone patch_displacement, of a needle that nobody holds deflection. The reference, where none is asked for, is the
/// costliest combination of models with all its parameters one step finer, or with its numbers alone, or as it is: the first of
/// these that is done within five minutes. What would take longer than one is given up and told of.
/// Nothing where it was stopped. Throws core::SceneErrors where the scene or the reference is wrong, Error where there is nothing
/// to compare.
[[nodiscard]] std::optional<Advice> advise(const Request& request, const std::atomic<bool>& stop,
                                           const std::function<void(const Progress&)>& progress);

}    // namespace stylet::study
