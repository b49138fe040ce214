#pragma once

#include "apps/study/result.h"

#include <string>

namespace stylet::app {

/// What a study found, for programs: '#' lines of what it is, a header, a row for each setting in full precision.
[[nodiscard]] std::string study_csv(const study::Result& result);

}    // namespace stylet::app
