#pragma once

#include "core/scene/reader.h"

namespace stylet::core {

/// SHA-1, in hexadecimal, of a scene's text, its overrides and the bytes of the files that it names: equal hashes, equal runs.
/// Where the files lie does not matter. Throws Error where a file cannot be read.
[[nodiscard]] std::string scene_hash(const std::string& text, const std::vector<Override>& overrides,
                                     const std::vector<std::filesystem::path>& files);

}    // namespace stylet::core
