// What a YAML text says, as a plain tree in which every value knows its place.
#pragma once

#include "core/scene/complaints.h"

#include <optional>
#include <string>
#include <vector>

namespace stylet::core {

struct ValueTree {
    enum class Shape { nothing, scalar, list, map };
    struct Entry;

    Shape shape = Shape::nothing;
    Place place;
    std::string text;                // of a scalar
    std::vector<ValueTree> items;    // of a list
    std::vector<Entry> entries;      // of a map, in the order written, each key once
    bool taken_out = false;          // of its list by an override; gone once all overrides are applied

    ValueTree() = default;
    ValueTree(Shape is, Place stands, std::string says = "");

    [[nodiscard]] const ValueTree* find(const std::string& key) const;
    [[nodiscard]] ValueTree* find(const std::string& key);
    [[nodiscard]] std::vector<std::string> keys() const;

    /// "nothing", "'25 kPa'", "a list" or "a map", as a sentence needs it.
    [[nodiscard]] std::string description() const;
};

struct ValueTree::Entry {
    std::string key;
    Place place;
    ValueTree value;
};

/// Reads one YAML document. Places count from `start` (line 0 gives that place to every value). A key written twice is complained
/// of and its first value kept; bad YAML, aliases, a second document and nesting deeper than 64 are complained of and give
/// nothing.
[[nodiscard]] std::optional<ValueTree> parse_yaml(const std::string& text, const Place& start, Complaints& complaints);

/// "needle" + "radius" → "needle.radius"
[[nodiscard]] std::string join(const std::string& path, const std::string& key);
/// "effects" + 1 → "effects[1]"
[[nodiscard]] std::string join(const std::string& path, std::size_t index);

}    // namespace stylet::core
