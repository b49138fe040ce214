#pragma once

#include "apps/study/result.h"

#include <string>

namespace stylet::app {

/// What a study found, as a page in Markdown with the picture at `picture_file`, which is told as seen from the page.
[[nodiscard]] std::string study_page(const study::Result& result, const std::string& picture_file);

}    // namespace stylet::app
