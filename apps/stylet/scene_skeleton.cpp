#include "apps/stylet/scene_skeleton.h"

#include "apps/stylet/kinds.h"
#include "core/loading/plugin_library.h"

#include <fmt/format.h>

#include <sstream>
#include <stdexcept>

namespace stylet::app {
namespace {

using core::Section;

std::string number_text(const Parameter& parameter) {
    return has_dimension(parameter) ? fmt::format("<number> {}", parameter.unit) : "<number>";
}

std::string value_text(const Parameter& parameter) {
    switch (parameter.kind) {
        case Kind::number:
            return number_text(parameter);
        case Kind::choice:
            return fmt::format("<{}>", range_text(parameter));
        case Kind::vector3:
            return fmt::format("[{0}, {0}, {0}]", number_text(parameter));
        default:
            return fmt::format("<{}>", name_of(parameter.kind));
    }
}

std::string indented(const std::string& block) {
    std::istringstream lines(block);
    std::string text;
    for (std::string line; std::getline(lines, line);) text += "  " + line + "\n";
    return text;
}

std::string item_of_list(const std::string& block) {
    std::string text = indented(block);
    text.front() = '-';
    return text;
}

std::string map_text(ParameterList parameters) {
    std::string text;
    for (const Parameter& parameter : parameters) {
        const char* const note = parameter.need == Need::optional ? "  # optional" : "";
        if (parameter.kind == Kind::records) {
            text += fmt::format("{}:{}\n{}", parameter.name, note, indented(item_of_list(map_text(fields_of(parameter)))));
        } else {
            text += fmt::format("{}: {}{}\n", parameter.name, value_text(parameter), note);
        }
    }
    return text;
}

/// What stands in the section: `type`, the section's own keys, and the plugin's where they belong.
std::string map_text(const Section& section, const Descriptor& plugin) {
    std::string text = fmt::format("type: {}\n", plugin.name) + map_text(section.keys);
    if (section.part != nullptr) {
        text += fmt::format("{}:  # optional\n  type: <{}>\n", section.part->key, core::name_of(*section.part->role));
    }
    const std::string own = map_text(parameters_of(plugin));
    if (!section.swappable || own.empty()) return text + own;
    return text + fmt::format("{}:\n{}", plugin.name, indented(own));
}

/// The section that `section` is a part of, or null.
const Section* whole_of(const Section& section) {
    for (const Section* whole : core::sections) {
        if (whole->part == &section) return whole;
    }
    return nullptr;
}

}    // namespace

const Section& section_of(Role role) {
    for (const Section* section : core::sections) {
        if (section->role == role) return *section;
        if (section->part != nullptr && section->part->role == role) return *section->part;
    }
    throw std::logic_error("no section of a scene names plugins of this role");
}

std::string path_of(const Section& section) {
    const Section* const whole = whole_of(section);
    return whole == nullptr ? section.key : fmt::format("{}.{}", whole->key, section.key);
}

std::string scene_skeleton(const Descriptor& plugin) {
    const Section& section = section_of(plugin.role);
    const Section* const whole = whole_of(section);
    const std::string map = map_text(section, plugin);
    const std::string block = section.shape == Section::Shape::map ? map : item_of_list(map);
    const std::string text = fmt::format("{}:\n{}", section.key, indented(block));
    return whole == nullptr ? text : fmt::format("{}:\n{}", whole->key, indented(text));
}

}    // namespace stylet::app
