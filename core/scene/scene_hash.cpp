#include "core/scene/scene_hash.h"

#include "core/scene/scene_files.h"

#include <fmt/format.h>
#include <boost/uuid/detail/sha1.hpp>

#include <cstdint>
#include <limits>

namespace stylet::core {
namespace {

/// Its length goes first, so that no two lists of texts run into the same bytes.
void add(boost::uuids::detail::sha1& sha, const std::string& bytes) {
    const std::string length = std::to_string(bytes.size()) + ":";
    sha.process_bytes(length.data(), length.size());
    sha.process_bytes(bytes.data(), bytes.size());
}

}    // namespace

std::string scene_hash(const std::string& text, const std::vector<Override>& overrides,
                       const std::vector<std::filesystem::path>& files) {
    boost::uuids::detail::sha1 sha;
    add(sha, text);
    for (const Override& override : overrides) {
        add(sha, override.key);
        add(sha, override.value);
    }
    for (const auto& file : files) add(sha, read_bytes(file, std::numeric_limits<std::size_t>::max()));
    boost::uuids::detail::sha1::digest_type digest;
    sha.get_digest(digest);
    std::string hash;
    for (const std::uint32_t word : digest) hash += fmt::format("{:08x}", word);
    return hash;
}

}    // namespace stylet::core
