// How a plugin stands in a scene.
#pragma once

#include "core/scene/scene_format.h"

#include <string>

namespace stylet::app {

/// The section that names the plugins of this role.
[[nodiscard]] const core::Section& section_of(Role role);

/// "needle.buckling", "effects"
[[nodiscard]] std::string path_of(const core::Section& section);

/// The section in YAML with every key that this plugin and the section ask for, values as `<number> N/m`: no value is made up.
[[nodiscard]] std::string scene_skeleton(const Descriptor& plugin);

}    // namespace stylet::app
