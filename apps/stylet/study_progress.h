#pragma once

#include "apps/study/run_study.h"
#include "apps/stylet/progress_bar.h"

namespace stylet::app {

/// A progress bar that says how much is done of how many runs, and how long it will take.
class StudyProgress {
public:
    explicit StudyProgress(const std::string& title) : bar_(title) {}

    void show(const study::Progress& progress);

private:
    ProgressBar bar_;
};

/// "3 min", "45 s": a time that is still to pass.
[[nodiscard]] std::string rough_time(double seconds);

}    // namespace stylet::app
