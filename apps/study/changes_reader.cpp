#include "apps/study/changes_reader.h"

#include "apps/study/changes.h"
#include "core/scene/wanted.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace stylet::study {
namespace {

using core::Reading;
using core::ValueTree;
using Shape = ValueTree::Shape;

constexpr Parameter varied_keys[] = {
    text("key", "the key of the scene that is varied, as --set names it"),
    optional(text("range", "an interval that it goes through, such as 0.1..1 mm; either this or `values`")),
    optional(integer("points", {.least = 2, .greatest = 1000}, "how many values the range has; wanted with it")),
    optional(choice("spacing", "linear log", "how they are spaced; wanted with a range")),
    optional(text("label", "what a point is called in table and picture, {} standing for the value; left out: KEY {}")),
};
constexpr const char* values_key = "values";

constexpr Parameter draw_keys[] = {
    text("key", "the key of the scene that is drawn, as --set names it"),
    optional(text("range", "the interval that it is drawn from, such as 5..100 kPa; either this or `one_of`")),
    optional(choice("spacing", "linear log", "whether every value is as likely, or every logarithm; wanted with a range")),
};
constexpr const char* one_of_key = "one_of";

/// As errors name it: the path's last part is not said again.
std::string given_at(const core::Place& place, const std::string& key) {
    return fmt::format("{}:{}:{}: {}", place.file, place.line, place.column, key);
}

std::string quoted(const std::string& text) {
    std::string result = "\"";
    for (const char c : text) {
        if (static_cast<unsigned char>(c) < 0x20) {
            result += fmt::format("\\x{:02x}", static_cast<unsigned char>(c));
        } else {
            if (c == '"' || c == '\\') result += '\\';
            result += c;
        }
    }
    return result + '"';
}

void complain(const ValueTree& node, const std::string& path, const std::string& sentence, Reading& reading) {
    reading.complaints.add(node.place, path, sentence);
}

/// The items of a list that is not empty; complains of anything else.
std::span<const ValueTree> items_of(const ValueTree& node, const std::string& path, const char* wanted, Reading& reading) {
    if (node.shape == Shape::list && !node.items.empty()) return node.items;
    const bool empty = node.shape == Shape::list;
    complain(node, path, fmt::format("found {}, wanted {}", empty ? "an empty list" : node.description(), wanted), reading);
    return {};
}

/// Every map of the list that stands under `key`, with its path.
template <class Use>
void each_map(const ValueTree& map, const std::string& path, const char* key, const char* meaning, Reading& reading, Use&& use) {
    const ValueTree* list = map.find(key);
    if (list == nullptr) return;
    const std::string list_path = core::join(path, key);
    const auto items = items_of(*list, list_path, "a list of maps", reading);
    for (std::size_t i = 0; i < items.size(); ++i) {
        const std::string item_path = core::join(list_path, i);
        if (core::is_map(items[i], item_path, meaning, reading)) use(items[i], item_path);
    }
}

std::vector<std::string> texts_of(const ValueTree& node, const std::string& path, Reading& reading) {
    std::vector<std::string> texts;
    for (const ValueTree& item : items_of(node, path, "a list of values", reading)) texts.push_back(yaml_text(item));
    return texts;
}

/// The range that `parameters` name, where it is one.
std::optional<Interval> range_of(const Parameters& parameters, const ValueTree& map, const std::string& path, Reading& reading) {
    const ValueTree& node = *map.find("range");
    const std::string range_path = core::join(path, "range");
    try {
        Interval range = read_interval(parameters.text("range"));
        const bool log = parameters.has("spacing") && parameters.text("spacing") == "log";
        if (range.one_value()) throw Error(fmt::format("found {}, wanted an interval such as 0.1..1 mm", node.description()));
        if (log && !(range.from > 0.0)) throw Error(fmt::format("found {}, wanted both ends above 0", node.description()));
        return range;
    } catch (const Error& error) {
        complain(node, range_path, error.what(), reading);
        return std::nullopt;
    }
}

Spacing spacing_of(const Parameters& parameters) {
    return parameters.has("spacing") && parameters.text("spacing") == "log" ? Spacing::log : Spacing::linear;
}

/// Complains unless there is one of the two, and with a range what goes with it.
bool check_range(const ValueTree& map, const std::string& path, const char* list_key, std::initializer_list<const char*> with,
                 Reading& reading) {
    const bool range = map.find("range") != nullptr, list = map.find(list_key) != nullptr;
    if (range == list) {
        const char* found = range ? "both" : "neither";
        complain(map, path, fmt::format("found {} of {} and range, wanted one", found, list_key), reading);
        return false;
    }
    bool sound = true;
    for (const char* key : with) {
        const bool there = map.find(key) != nullptr;
        if (range && !there) core::miss_key(map, core::join(path, key), "one beside 'range'", reading);
        if (!range && there) complain(*map.find(key), core::join(path, key), "found no 'range' that it belongs to", reading);
        sound = sound && there == range;
    }
    return sound;
}

void check_known(const ValueTree& map, const std::string& path, std::span<const Parameter> declared, const char* more,
                 Reading& reading) {
    std::vector<std::string> known = core::names_of(declared);
    known.emplace_back(more);
    core::refuse_unknown_keys(map, path, known, reading);
}

Vary read_vary(const ValueTree& map, const std::string& path, Reading& reading) {
    const Parameters parameters = core::read_parameters(map, path, varied_keys, reading);
    check_known(map, path, varied_keys, values_key, reading);
    Vary vary;
    if (parameters.has("key")) vary.key = parameters.text("key");
    vary.label = parameters.has("label") ? parameters.text("label") : vary.key + " {}";
    vary.given = given_at(map.place, vary.key);
    if (!check_range(map, path, values_key, {"points", "spacing"}, reading)) return vary;
    if (const ValueTree* values = map.find(values_key)) {
        vary.values = texts_of(*values, core::join(path, values_key), reading);
    } else if (parameters.has("points") && parameters.has("range")) {
        const std::optional<Interval> range = range_of(parameters, map, path, reading);
        if (!range) return vary;
        for (const double value : range->values(static_cast<int>(parameters.integer("points")), spacing_of(parameters)))
            vary.values.push_back(quoted(range->quantity(value)));
    }
    return vary;
}

Draw read_draw(const ValueTree& map, const std::string& path, Reading& reading) {
    const Parameters parameters = core::read_parameters(map, path, draw_keys, reading);
    check_known(map, path, draw_keys, one_of_key, reading);
    Draw draw;
    if (parameters.has("key")) draw.key = parameters.text("key");
    draw.given = given_at(map.place, draw.key);
    draw.spacing = spacing_of(parameters);
    if (!check_range(map, path, one_of_key, {"spacing"}, reading)) return draw;
    if (const ValueTree* values = map.find(one_of_key)) {
        draw.one_of = texts_of(*values, core::join(path, one_of_key), reading);
    } else if (parameters.has("range")) {
        if (auto range = range_of(parameters, map, path, reading)) draw.range = *std::move(range);
    }
    return draw;
}

}    // namespace

std::string yaml_text(const ValueTree& tree) {
    std::vector<std::string> parts;
    switch (tree.shape) {
        case Shape::nothing:
            return "~";
        case Shape::scalar:
            return quoted(tree.text);
        case Shape::list:
            for (const ValueTree& item : tree.items) parts.push_back(yaml_text(item));
            return fmt::format("[{}]", fmt::join(parts, ", "));
        case Shape::map:
            for (const ValueTree::Entry& entry : tree.entries)
                parts.push_back(fmt::format("{}: {}", quoted(entry.key), yaml_text(entry.value)));
            return fmt::format("{{{}}}", fmt::join(parts, ", "));
    }
    return "~";
}

std::vector<core::Override> read_changes(const ValueTree& map, const std::string& path, Reading& reading) {
    std::vector<core::Override> changes;
    if (const ValueTree* keys = map.find(leave_out_key)) {
        const std::string list_path = core::join(path, leave_out_key);
        const auto items = items_of(*keys, list_path, "a list of the scene's keys, such as [\"effects[1]\"]", reading);
        for (std::size_t i = 0; i < items.size(); ++i) {
            if (items[i].shape != Shape::scalar)
                complain(items[i], core::join(list_path, i), fmt::format("found {}, wanted a key", items[i].description()),
                         reading);
            changes.push_back(
                {.key = items[i].text, .value = "", .given = given_at(items[i].place, items[i].text), .removes = true});
        }
    }
    const ValueTree* set = map.find(set_key);
    if (set == nullptr || !core::is_map(*set, core::join(path, set_key), "keys of the scene and what they become", reading))
        return joined({}, changes);
    for (const ValueTree::Entry& entry : set->entries)
        changes.push_back({.key = entry.key, .value = yaml_text(entry.value), .given = given_at(entry.place, entry.key)});
    return joined({}, changes);
}

std::vector<Vary> read_varied(const ValueTree& map, const std::string& path, Reading& reading) {
    std::vector<Vary> varied;
    each_map(map, path, vary_key, "a key that is varied", reading,
             [&](const ValueTree& item, const std::string& item_path) { varied.push_back(read_vary(item, item_path, reading)); });
    return varied;
}

std::vector<Draw> read_draws(const ValueTree& map, const std::string& path, Reading& reading) {
    std::vector<Draw> draws;
    each_map(map, path, "draw", "a key that is drawn", reading,
             [&](const ValueTree& item, const std::string& item_path) { draws.push_back(read_draw(item, item_path, reading)); });
    return draws;
}

core::Override Draw::at(double share) const {
    if (!one_of.empty()) {
        const auto last = static_cast<double>(one_of.size() - 1);
        const double index = std::min(std::floor(share * static_cast<double>(one_of.size())), last);
        return {.key = key, .value = one_of[static_cast<std::size_t>(index)], .given = given};
    }
    return {.key = key, .value = quoted(range.quantity(rounded(range.at(share, spacing)))), .given = given};
}

}    // namespace stylet::study
