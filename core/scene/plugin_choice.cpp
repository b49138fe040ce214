#include "core/scene/plugin_choice.h"

#include "core/loading/plugin_library.h"

#include <algorithm>
#include <iterator>

namespace stylet::core {
namespace {

std::optional<PluginLibrary> open_plugin(const std::string& type, Role role, const Place& place, const std::string& path,
                                         Reading& reading) {
    try {
        return PluginLibrary::open(type, role, reading.folders);
    } catch (const Error& error) {
        reading.complaints.add(place, path, error.what());
        return std::nullopt;
    }
}

std::span<const Parameter> declarations(const PluginLibrary& library) {
    return {library.descriptor().parameters, library.descriptor().parameter_count};
}

/// The plugin that the map's `type` names, its parameters still to be read; an empty `type` where it names none.
Choice read_type(const ValueTree& map, const std::string& path, Role role, Reading& reading) {
    Choice choice{.type = "", .path = path, .place = map.place, .parameters = {}};
    const std::string wanted = std::string("the name of ") + with_article(role);
    const ValueTree* type = map.find("type");
    if (type == nullptr) {
        miss_key(map, join(path, "type"), wanted, reading);
    } else if (type->text.empty()) {    // of a list or a map, too
        reading.complaints.add(type->place, join(path, "type"), "found " + type->description() + ", wanted " + wanted);
    } else {
        choice.type = type->text;
        choice.place = type->place;
    }
    return choice;
}

/// The keys of a section that are core's own.
std::vector<std::string> own_keys(const Section& section) {
    std::vector<std::string> keys{"type"};
    std::ranges::copy(names_of(section.keys), std::back_inserter(keys));
    if (section.part != nullptr) keys.emplace_back(section.part->key);
    return keys;
}

Parameters read_own_map(const ValueTree& map, const std::string& path, const PluginLibrary& library, Reading& reading) {
    if (!is_map(map, path, "the plugin's own parameters", reading)) return {};
    Parameters parameters = read_parameters(map, path, declarations(library), reading);
    refuse_unknown_keys(map, path, names_of(declarations(library)), reading);
    return parameters;
}

/// True of the map of a plugin of the role.
bool check_other_map(const ValueTree::Entry& entry, const std::string& path, Role role, const std::vector<std::string>& known,
                     Reading& reading) {
    if (!reading.folders.find(entry.key)) {
        std::vector<std::string> candidates = known;
        std::ranges::copy(reading.folders.names(), std::back_inserter(candidates));
        const std::string wanted = "one of " + list_of(known) + ", or a map named after " + with_article(role);
        refuse_unknown_key(entry, path, wanted, candidates, reading);
        return false;
    }
    const std::string own_path = join(path, entry.key);
    const auto library = open_plugin(entry.key, role, entry.place, own_path, reading);
    if (library) read_own_map(entry.value, own_path, *library, reading);
    return library.has_value();
}

/// Parameters beside the `type`.
void read_beside(const ValueTree& map, const PluginLibrary& library, std::vector<std::string> known, Choice& choice,
                 Reading& reading) {
    choice.parameters = read_parameters(map, choice.path, declarations(library), reading);
    std::ranges::copy(names_of(declarations(library)), std::back_inserter(known));
    refuse_unknown_keys(map, choice.path, known, reading);
}

/// Parameters in a map named after the plugin.
void read_within(const ValueTree& map, const PluginLibrary& library, Choice& choice, Reading& reading) {
    choice.within = join(choice.path, choice.type);
    const ValueTree nothing_given(ValueTree::Shape::map, map.place);
    const ValueTree* own = map.find(choice.type);
    choice.parameters = read_own_map(own == nullptr ? nothing_given : *own, choice.within, library, reading);
}

void check_other_maps(const ValueTree& map, Role role, const std::vector<std::string>& known, Choice& choice, Reading& reading) {
    for (const ValueTree::Entry& entry : map.entries) {
        const bool other = entry.key != choice.type && std::ranges::find(known, entry.key) == known.end();
        if (other && check_other_map(entry, choice.path, role, known, reading)) choice.alternatives.push_back(entry.key);
    }
}

}    // namespace

Choice read_choice(const ValueTree& map, const std::string& path, const Section& section, Reading& reading) {
    const Role role = section.role.value();
    Choice choice = read_type(map, path, role, reading);
    const std::vector<std::string> known = own_keys(section);
    if (section.swappable) check_other_maps(map, role, known, choice, reading);
    if (choice.type.empty()) return choice;
    const auto library = open_plugin(choice.type, role, choice.place, join(path, "type"), reading);
    if (!library) return choice;
    if (section.swappable) {
        read_within(map, *library, choice, reading);
    } else {
        read_beside(map, *library, known, choice, reading);
    }
    return choice;
}

}    // namespace stylet::core
