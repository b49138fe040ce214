#include "core/scene/scene_hash.h"

#include "core/scene/scene_files.h"
#include "core/scene/sha1.h"

#include <limits>

namespace stylet::core {

std::string scene_hash(const std::string& text, const std::vector<Override>& overrides,
                       const std::vector<std::filesystem::path>& files) {
    Sha1 sha;
    sha.add(text);
    for (const Override& override : overrides) {
        sha.add(override.removes ? "taken out" : "set");
        sha.add(override.key);
        sha.add(override.removes ? "" : override.value);
    }
    for (const auto& file : files) sha.add(read_bytes(file, std::numeric_limits<std::size_t>::max()));
    return sha.hexadecimal();
}

}    // namespace stylet::core
