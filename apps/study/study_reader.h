#pragma once

#include "apps/study/study.h"
#include "core/loading/plugin_folders.h"

namespace stylet::study {

/// Reads and checks a study; the scenes that it leads to are read when they are planned. Throws core::SceneErrors with all that
/// is wrong with it.
[[nodiscard]] Study read_study(const std::filesystem::path& file, const core::PluginFolders& folders);

}    // namespace stylet::study
