#pragma once

#include "core/loading/plugin_folders.h"
#include "core/scene/scene.h"

namespace stylet::app {

/// [N] at which the needle's tip punctures the surface at time 0, asked of the scene's effects as a run asks them; infinite where
/// none of them limits it. Throws core::SceneErrors where an effect cannot be made.
[[nodiscard]] double puncture_force(const core::Scene& scene, const core::PluginFolders& folders);

}    // namespace stylet::app
