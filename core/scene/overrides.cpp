#include "core/scene/overrides.h"

#include "core/scene/suggestion.h"

#include <fmt/format.h>

#include <charconv>
#include <variant>

namespace stylet::core {
namespace {

using Step = std::variant<std::string, std::size_t>;    // a map's key or a list's index

bool is_word_letter(char c) {
    return c != '.' && c != '[' && c != ']';
}

/// "effects[0].rupture_force" → effects, 0, rupture_force; nothing where it is malformed.
std::vector<Step> steps_of(const std::string& key) {
    std::vector<Step> steps;
    const char* at = key.data();
    const char* const end = at + key.size();
    while (at != end) {
        if (*at == '[') {
            std::size_t index = 0;
            const auto [stop, error] = std::from_chars(at + 1, end, index);
            if (steps.empty() || error != std::errc{} || stop == end || *stop != ']') return {};
            steps.emplace_back(index);
            at = stop + 1;
        } else {
            if (!steps.empty() && *at++ != '.') return {};
            const char* const begin = at;
            while (at != end && is_word_letter(*at)) ++at;
            if (at == begin) return {};
            steps.emplace_back(std::string(begin, at));
        }
    }
    return steps;
}

/// The value that one step leads to. Where the key is not there yet, it is made if it may be.
ValueTree* follow(ValueTree& from, const Step& step, const std::string& path, bool may_make, const Place& place,
                  std::string& problem) {
    if (const auto* index = std::get_if<std::size_t>(&step)) {
        if (from.shape == ValueTree::Shape::list && *index < from.items.size()) {
            if (!from.items[*index].taken_out) return &from.items[*index];
            problem = fmt::format("found no item [{}], it was taken out of {}", *index, quote(path));
            return nullptr;
        }
        problem = from.shape == ValueTree::Shape::list
                      ? fmt::format("found no item [{}], {} is a list of {}", *index, quote(path), from.items.size())
                      : fmt::format("found {} at {}, wanted a list", from.description(), quote(path));
        return nullptr;
    }
    const auto& key = std::get<std::string>(step);
    if (from.shape != ValueTree::Shape::map) {
        problem = fmt::format("found {} at {}, wanted a map", from.description(), quote(path));
        return nullptr;
    }
    if (ValueTree* found = from.find(key)) return found;
    if (may_make) {
        from.entries.push_back({key, place, {}});
        return &from.entries.back().value;
    }
    problem = fmt::format("found no key {} in the scene{}", quote(join(path, key)), suggestion(key, from.keys()));
    return nullptr;
}

/// Where an override's steps lead, and the map or list in which the last of them is; nothing where they lead nowhere.
struct Target {
    ValueTree* parent = nullptr;
    ValueTree* value = nullptr;
};

Target find(const Override& override, const std::vector<Step>& steps, const Place& place, ValueTree& scene,
            std::string& problem) {
    Target target{.value = &scene};
    std::string path;
    for (std::size_t i = 0; i < steps.size(); ++i) {
        ValueTree& at = *target.value;
        const bool may_make = !override.removes && (override.makes_way || i + 1 == steps.size());
        if (may_make && override.makes_way && at.shape == ValueTree::Shape::nothing) at = ValueTree(ValueTree::Shape::map, place);
        target = {.parent = &at, .value = follow(at, steps[i], path, may_make, place, problem)};
        if (target.value == nullptr) return {};
        path = std::visit([&](const auto& step) { return join(path, step); }, steps[i]);
    }
    return target;
}

/// An item of a list is only marked, so that the others keep their indices.
void take_out(const Target& target, const Step& last) {
    if (const auto* key = std::get_if<std::string>(&last)) {
        std::erase_if(target.parent->entries, [&](const ValueTree::Entry& entry) { return entry.key == *key; });
    } else {
        target.value->taken_out = true;
    }
}

void apply(const Override& override, ValueTree& scene, Complaints& complaints) {
    const Place place{override.given, 0, 0};
    const std::vector<Step> steps = steps_of(override.key);
    if (steps.empty()) {
        complaints.add(place, "", "found a malformed key, wanted one such as effects[0].rupture_force");
        return;
    }
    std::optional<ValueTree> value;
    if (!override.removes) {
        value = parse_yaml(override.value, place, complaints);
        if (!value) return;
    }
    std::string problem;
    const Target target = find(override, steps, place, scene, problem);
    if (target.value == nullptr) {
        complaints.add(place, "", problem);
    } else if (override.removes) {
        take_out(target, steps.back());
    } else {
        *target.value = *std::move(value);
    }
}

void sweep(ValueTree& tree) {
    std::erase_if(tree.items, [](const ValueTree& item) { return item.taken_out; });
    for (ValueTree& item : tree.items) sweep(item);
    for (ValueTree::Entry& entry : tree.entries) sweep(entry.value);
}

}    // namespace

void apply_overrides(const std::vector<Override>& overrides, ValueTree& scene, Complaints& complaints) {
    for (const Override& override : overrides) apply(override, scene, complaints);
    sweep(scene);
}

}    // namespace stylet::core
