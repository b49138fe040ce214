#pragma once

#include "apps/stylet/figure.h"

#include <filesystem>
#include <string>

namespace stylet::app {

/// What gnuplot is to do to leave figure.svg and figure.png in its working folder.
[[nodiscard]] std::string gnuplot_script(const Figure& figure);

struct PictureFiles {
    std::filesystem::path svg;
    std::filesystem::path png;
};

/// Draws with gnuplot, as a process without a shell. Throws Failure where gnuplot is missing or the files cannot be written.
PictureFiles draw(const Figure& figure, const std::filesystem::path& stem);

}    // namespace stylet::app
