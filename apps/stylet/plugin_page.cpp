#include "apps/stylet/plugin_page.h"

#include "apps/stylet/kinds.h"
#include "apps/stylet/markdown.h"
#include "apps/stylet/scene_skeleton.h"

#include <fmt/format.h>

#include <cctype>

namespace stylet::app {
namespace {

constexpr const char* origin =
    "<!-- Written by `stylet plugins --pages` from what the plugins declare: change it there, then write it again. -->\n\n";

std::string sentence(const std::string& text) {
    return markdown(text) + (text.ends_with('.') ? "\n" : ".\n");
}

void add_rows(ParameterList parameters, const std::string& path, std::string& rows) {
    for (const Parameter& parameter : parameters) {
        const std::string name = path + parameter.name;
        rows += fmt::format("| `{}` | {} | {} | {} | {} |\n", name, markdown_cell(kind_text(parameter)),
                            markdown_cell(range_text(parameter)), need_text(parameter), markdown_cell(meaning_text(parameter)));
        add_rows(fields_of(parameter), name + "[].", rows);
    }
}

std::string table(ParameterList parameters, const std::string& last_row = "") {
    std::string rows = "| key | kind (unit) | range (SI) | needed | meaning |\n|---|---|---|---|---|\n";
    add_rows(parameters, "", rows);
    return rows + last_row;
}

std::string own_parameters(const Descriptor& plugin, const core::Section& section) {
    const ParameterList parameters = parameters_of(plugin);
    if (parameters.empty()) return "It has no parameters of its own.\n";
    const std::string where = section.swappable ? fmt::format("In a map `{}` beside `type`", plugin.name) : "Beside `type`";
    return fmt::format("{}:\n\n{}", where, table(parameters));
}

/// Empty where the role has no keys of its own.
std::string shared_keys(const core::Section& section) {
    if (section.keys.empty()) return "";
    std::string part;
    if (section.part != nullptr)
        part = fmt::format("| `{}` | map with a `type` |  | optional | {} |\n", section.part->key, section.part->meaning);
    return fmt::format("\n## Keys of every {}\n\n{}", core::name_of(*section.role), table(section.keys, part));
}

std::string capitalised(std::string text) {
    text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
    return text;
}

}    // namespace

std::string plugin_page(const Descriptor& plugin) {
    const core::Section& section = section_of(plugin.role);
    const About& about = plugin.about;
    return fmt::format("{}# {}\n\n**{}.** {}", origin, plugin.name, capitalised(core::name_of(plugin.role)),
                       sentence(about.summary)) +
           fmt::format("\n## Formula\n\n```text\n{}\n```\n", about.formula) +
           fmt::format("\n## Validity\n\n{}\n## Source\n\n{}", sentence(about.validity), sentence(about.source)) +
           fmt::format("\n## Parameters\n\n{}{}", own_parameters(plugin, section), shared_keys(section)) +
           fmt::format("\n## In a scene\n\n```yaml\n{}```\n\n[All plugins](README.md)\n", scene_skeleton(plugin));
}

std::string plugin_index(std::span<const core::PluginLibrary> plugins) {
    std::string text =
        fmt::format("{}# Plugins\n\nWhat a scene can name as a `type`, by role. `stylet plugins NAME` tells the same.\n", origin);
    for (std::size_t i = 0; i < plugins.size(); ++i) {
        const Descriptor& plugin = plugins[i].descriptor();
        const bool first_of_role = i == 0 || plugins[i - 1].descriptor().role != plugin.role;
        if (first_of_role) {
            text += fmt::format("\n## {}s\n\nNamed under `{}`.\n\n", capitalised(core::name_of(plugin.role)),
                                path_of(section_of(plugin.role)));
        }
        text += fmt::format("- [{0}]({0}.md): {1}", plugin.name, sentence(plugin.about.summary));
    }
    return text;
}

}    // namespace stylet::app
