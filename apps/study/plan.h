// All that a study measures, each thing once.
#pragma once

#include "apps/study/job.h"
#include "apps/study/settings.h"

#include <atomic>

namespace stylet::study {

struct Plan {
    std::vector<Setting> settings;
    std::vector<Job> jobs;

    // Which job each setting is in each case: [setting][case].
    std::vector<std::vector<std::size_t>> mine;
    std::vector<std::vector<std::size_t>> references;    // empty where the reference is no run
    std::vector<std::vector<std::size_t>> twins;         // empty where the error is not split
};

/// Reads every scene. Throws core::SceneErrors with all that is wrong with any of them. Once `stop` is set it soon ends, and what
/// it gives is no whole plan.
[[nodiscard]] Plan plan_of(const Study& study, const core::PluginFolders& folders, const std::string& processor,
                           const std::atomic<bool>* stop = nullptr);

}    // namespace stylet::study
