// The plugins that a scene names. Their libraries are opened for their declarations and closed again.
#pragma once

#include "core/scene/parameter_reader.h"
#include "core/scene/scene_format.h"

namespace stylet::core {

/// The plugin that `map`, standing at `path`, names as its `type`, with its parameters: beside the `type`, together with the
/// section's own keys (read by the caller); of a swappable section in a map named after it, beside the maps of other plugins of
/// the role, which are checked too: swapping is one word. `section` has a role.
[[nodiscard]] Choice read_choice(const ValueTree& map, const std::string& path, const Section& section, Reading& reading);

}    // namespace stylet::core
