// All the plugins that there are.
#pragma once

#include "core/loading/plugin_library.h"

#include <vector>

namespace stylet::app {

/// Sorted by role, then name. A library that is refused is told of on stderr; the others are listed all the same.
[[nodiscard]] std::vector<core::PluginLibrary> all_plugins(const core::PluginFolders& folders);

}    // namespace stylet::app
