// The plugins that a scene names. Their libraries are opened for their declarations and closed again.
#pragma once

#include "core/scene/parameter_reader.h"

#include <stylet/plugin.h>

namespace stylet::core {

/// A plugin whose parameters stand beside its `type`, together with keys of core's (`common`, read by the caller).
[[nodiscard]] Choice read_inline_choice(const ValueTree& map, const std::string& path, Role role,
                                        const std::vector<std::string>& common, Reading& reading);

/// A plugin whose parameters stand in a map named after it, beside keys of core's (`common`, read by the caller) and the maps of
/// other plugins of the role, which are checked too: swapping is one word.
[[nodiscard]] Choice read_swappable_choice(const ValueTree& map, const std::string& path, Role role,
                                           const std::vector<std::string>& common, Reading& reading);

}    // namespace stylet::core
