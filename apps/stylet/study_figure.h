#pragma once

#include "apps/study/result.h"
#include "apps/stylet/gnuplot.h"

namespace stylet::app {

/// Error over time, both logarithmic, each setting named.
[[nodiscard]] Figure figure_of(const study::Result& result);

/// Leaves the picture as <stem>.svg and <stem>.png. Throws Failure as draw() does.
PictureFiles draw_study(const study::Result& result, const std::filesystem::path& stem);

}    // namespace stylet::app
