// A JSON Schema of a scene, for editors: made from the declarations that also read and check one.
#pragma once

#include "core/loading/plugin_library.h"

#include <span>
#include <string>

namespace stylet::app {

/// Draft 7, which YAML language servers know best; `enumDescriptions` and `errorMessage` are theirs, other readers pass over
/// them. A scene may name these plugins and no others. What the schema refuses, the reader refuses too, but for a quoted number
/// and a negative zero; the reader sees more: dimensions, files, what several keys say together.
[[nodiscard]] std::string scene_schema(std::span<const core::PluginLibrary> plugins);

}    // namespace stylet::app
