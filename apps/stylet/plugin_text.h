// A plugin's documentation, from the declarations that also read and check its parameters.
#pragma once

#include "core/loading/plugin_library.h"

#include <span>
#include <string>

namespace stylet::app {

/// What it is, its formula, source and validity, and a line for each parameter with its meaning below it; the fields of records
/// further in.
[[nodiscard]] std::string plugin_text(const core::PluginLibrary& library);

/// The same as JSON: an object, or an array of one for each.
[[nodiscard]] std::string plugin_json(const core::PluginLibrary& library);
[[nodiscard]] std::string plugins_json(std::span<const core::PluginLibrary> libraries);

}    // namespace stylet::app
