#pragma once

#include "apps/study/result.h"

#include <string>

namespace stylet::app {

/// What a study found, for a terminal: a row for each setting, the fitted orders, the machine, and the sentences to end with.
[[nodiscard]] std::string study_text(const study::Result& result);

}    // namespace stylet::app
