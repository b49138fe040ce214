#pragma once

#include "apps/study/plan.h"
#include "apps/study/run_study.h"

namespace stylet::study {

/// Measures a plan's jobs, those that the log does not know yet: one after the other where they are timed, else as many at once
/// as there are processors. What each job left; nothing where it was stopped before. Throws Error where another study is at the
/// log, std::system_error where it cannot be written.
[[nodiscard]] std::vector<std::optional<Outcome>> measure_all(const Plan& plan, bool timed, const Options& options);

}    // namespace stylet::study
