#include "apps/stylet/study_progress.h"

#include <fmt/format.h>

#include <cmath>

namespace stylet::app {

std::string rough_time(double seconds) {
    constexpr double minute = 60.0, hour = 3600.0;    // [s]
    if (seconds < 2.0 * minute) return fmt::format("{:.0f} s", std::ceil(seconds));
    if (seconds < 2.0 * hour) return fmt::format("{:.0f} min", seconds / minute);
    return fmt::format("{:.1f} h", seconds / hour);
}

namespace {

/// As much of it as a line of a terminal has room for beside the rest.
std::string short_name(const std::string& name) {
    constexpr std::size_t longest = 24;
    return name.size() <= longest ? name : name.substr(0, longest) + "…";
}

}    // namespace

void StudyProgress::show(const study::Progress& progress) {
    const std::string left = progress.seconds_left ? fmt::format(", {} left", rough_time(*progress.seconds_left)) : "";
    bar_.show(progress.share, fmt::format("{} of {}{}: {}", progress.done, progress.all, left, short_name(progress.name)));
}

}    // namespace stylet::app
