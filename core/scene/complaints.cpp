#include "core/scene/complaints.h"

#include "core/scene/reader.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <tuple>

namespace stylet::core {
namespace {

/// A character of UTF-8 stays whole.
std::string shortened(const std::string& text, std::size_t longest) {
    constexpr std::size_t rest = 3;    // [bytes] a character's most after its first
    const auto inside_a_character = [&](std::size_t at) { return (static_cast<unsigned char>(text[at]) & 0xC0) == 0x80; };
    std::size_t end = std::min(text.size(), longest);
    while (end < std::min(text.size(), longest + rest) && inside_a_character(end)) ++end;
    return end < text.size() ? text.substr(0, end) + "…" : text;
}

}    // namespace

SceneErrors::SceneErrors(std::vector<std::string> messages)
    : std::runtime_error(fmt::format("{}", fmt::join(messages, "\n"))), messages_(std::move(messages)) {}

void Complaints::add(const Place& place, const std::string& path, const std::string& sentence) {
    complaints_.push_back({place, path, sentence});
}

std::vector<std::string> Complaints::messages() const {
    constexpr std::size_t longest = 120;    // [bytes] of a path: no key of a plugin lies deeper
    std::vector<Complaint> sorted = complaints_;
    std::ranges::stable_sort(sorted, {}, [](const Complaint& complaint) {
        const Place& place = complaint.place;
        return std::tuple(place.line == 0, place.line, place.column);
    });
    std::vector<std::string> messages;
    for (const auto& [place, path, sentence] : sorted) {
        std::string message = place.file;
        if (place.line > 0) message += fmt::format(":{}:{}", place.line, place.column);
        // The place of an override already says its path.
        const bool said = place.line == 0 && place.file.ends_with(" " + path);
        if (!path.empty() && !said) message += ": " + shortened(path, longest);
        messages.push_back(printable(message + ": " + sentence));
    }
    return messages;
}

void Complaints::throw_if_any() const {
    if (!complaints_.empty()) throw SceneErrors(messages());
}

std::string printable(const std::string& text) {
    std::string shown;
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte < 0x20 || byte == 0x7F) {
            shown += fmt::format("\\x{:02x}", byte);
        } else {
            shown += c;
        }
    }
    return shown;
}

std::string quote(const std::string& text) {
    constexpr std::size_t longest = 60;    // [bytes] what a terminal's line bears
    return fmt::format("'{}'", printable(shortened(text, longest)));
}

std::string list_of(const std::vector<std::string>& words) {
    return fmt::format("{}", fmt::join(words, ", "));
}

}    // namespace stylet::core
