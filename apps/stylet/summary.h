// What a run came to, for people and for programs.
#pragma once

#include "core/run/report.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace stylet::app {

/// Pictures for other tools.
struct FinishedSeries {
    std::vector<std::filesystem::path> files;    // PVD
    int moments;                                 // in each of them
    double period;                               // [s] from one to the next
};

struct FinishedRun {
    std::string scene;        // as the user named it
    std::string recording;    // path of the CSV
    core::RunReport report;
    std::optional<FinishedSeries> series{};
};

[[nodiscard]] std::string summary_text(const FinishedRun& run);

/// JSON whose layout is a promise to scripts; SI units, times of ticks in µs, a number that is not finite as null.
[[nodiscard]] std::string summary_json(const FinishedRun& run);

/// Whether an event says that the run could not go on as the scene wanted.
[[nodiscard]] bool ended_in_fault(const core::RunReport& report);

}    // namespace stylet::app
