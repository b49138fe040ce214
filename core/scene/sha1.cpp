#include "core/scene/sha1.h"

#include <fmt/format.h>

#include <cstdint>

namespace stylet::core {

void Sha1::add(const std::string& bytes) {
    // Its length goes first, so that no two lists of texts run into the same bytes.
    const std::string length = std::to_string(bytes.size()) + ":";
    sha_.process_bytes(length.data(), length.size());
    sha_.process_bytes(bytes.data(), bytes.size());
}

std::string Sha1::hexadecimal() {
    boost::uuids::detail::sha1::digest_type digest;
    sha_.get_digest(digest);
    std::string text;
    for (const std::uint32_t word : digest) text += fmt::format("{:08x}", word);
    return text;
}

}    // namespace stylet::core
