#pragma once

#include "apps/stylet/critical_loads.h"

#include <string>

namespace stylet::app {

/// One scene's share of a question. Throws core::SceneErrors with all that is wrong with it.
[[nodiscard]] SceneLoads scene_loads(const LoadQuestion& question, const std::string& file);

}    // namespace stylet::app
