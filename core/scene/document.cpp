#include "core/scene/document.h"

#include "core/scene/common_keys.h"
#include "core/scene/reader.h"

#include <fmt/format.h>

#include <algorithm>

namespace stylet::core {
namespace {

constexpr std::size_t largest = 1 << 20;    // [bytes] a written document has some thousand; more is none

[[noreturn]] void refuse(const Place& place, const std::string& path, const std::string& sentence) {
    Complaints complaints;
    complaints.add(place, path, sentence);
    throw SceneErrors(complaints.messages());
}

/// Where the first byte stands that is no UTF-8, or npos.
std::size_t not_utf8(const std::string& text) {
    for (std::size_t i = 0; i < text.size();) {
        const auto byte = static_cast<unsigned char>(text[i]);
        const std::size_t more = byte < 0x80                   ? 0
                                 : byte >= 0xC2 && byte < 0xE0 ? 1
                                 : byte >= 0xE0 && byte < 0xF0 ? 2
                                 : byte >= 0xF0 && byte < 0xF5 ? 3
                                                               : 4;
        for (std::size_t k = 1; k <= more; ++k) {
            const bool continues = more < 4 && i + k < text.size() && (static_cast<unsigned char>(text[i + k]) & 0xC0) == 0x80;
            if (!continues) return i;
        }
        i += more + 1;
    }
    return std::string::npos;
}

}    // namespace

std::string document_text(const std::filesystem::path& file, const std::string& kind) {
    try {
        std::string text = read_bytes(file, largest);
        if (const std::size_t at = not_utf8(text); at != std::string::npos) {
            const auto line =
                static_cast<int>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n')) + 1;
            const auto column = static_cast<int>(at - (text.rfind('\n', at) + 1)) + 1;
            refuse({file.string(), line, column}, "", fmt::format("found a byte that is no UTF-8, wanted {} in UTF-8", kind));
        }
        return text;
    } catch (const Error& error) {
        refuse({file.string(), 0, 0}, "", fmt::format("{}, wanted {}", error.what(), kind));
    }
}

ValueTree document_tree(const std::string& text, const std::filesystem::path& file, const std::string& kind,
                        Complaints& complaints) {
    const Place start{file.string(), 1, 1};
    std::optional<ValueTree> root = parse_yaml(text, start, complaints);
    if (!root) throw SceneErrors(complaints.messages());
    if (root->shape == ValueTree::Shape::nothing)
        refuse(start, "", fmt::format("found an empty file, wanted {} that begins with 'stylet: {}'", kind, format_version));
    if (root->shape != ValueTree::Shape::map)
        refuse(root->place, "", fmt::format("found {}, wanted a map of {}'s keys", root->description(), kind));
    return *std::move(root);
}

void check_version(const ValueTree& root, const std::string& kind, Reading& reading) {
    const ValueTree* version = root.find("stylet");
    const std::string noun = kind.substr(kind.find(' ') + 1);
    const std::string wanted = fmt::format("{} (the version of the {} format)", format_version, noun);
    if (version == nullptr) {
        miss_key(root, "stylet", wanted, reading);
    } else if (version->text != std::to_string(format_version)) {
        refuse(version->place, "stylet", "found " + version->description() + ", wanted " + wanted);
    }
}

bool is_study(const ValueTree& root) {
    return root.find("series") != nullptr;
}

}    // namespace stylet::core
