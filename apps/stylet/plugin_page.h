// Markdown pages of plugins, from the declarations that also read and check their parameters.
#pragma once

#include "core/loading/plugin_library.h"

#include <span>
#include <string>

namespace stylet::app {

/// One plugin: formula, validity, source, parameters, the keys that it shares with its role, and how it stands in a scene.
[[nodiscard]] std::string plugin_page(const Descriptor& plugin);

/// A line for each plugin, by role, with a link to <name>.md beside it.
[[nodiscard]] std::string plugin_index(std::span<const core::PluginLibrary> plugins);

}    // namespace stylet::app
