#include "apps/stylet/schema.h"

#include "apps/stylet/parameter_schema.h"
#include "core/run/sample.h"
#include "core/scene/scene_format.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace stylet::app {
namespace {

using core::Section;
using nlohmann::ordered_json;

constexpr const char* about =
    "A scene of Stylet and the plugins that it can name. A number with a dimension carries its unit ('25 kPa'), one without "
    "carries none. stylet check sees more than an editor: whether a unit fits, files, and what several keys say together.";

/// The schemas of one set of plugins: each plugin's own map once, under `definitions`, referred to by the sections.
class SceneSchema {
public:
    explicit SceneSchema(std::span<const core::PluginLibrary> plugins) {
        for (const core::PluginLibrary& plugin : plugins) plugins_.push_back(&plugin.descriptor());
    }

    ordered_json of_scene() {
        ordered_json schema = map_schema(core::scene_keys);
        put_first("stylet", {{"const", core::format_version}, {"description", "the version of the scene format"}}, schema);
        for (const Section* section : core::sections) schema["properties"][section->key] = of_section(*section);
        schema["required"].push_back(core::run_section.key);
        schema["allOf"] = presence_rules();
        schema["definitions"] = definitions_;
        ordered_json whole{
            {"$schema", "http://json-schema.org/draft-07/schema#"}, {"title", "Stylet scene"}, {"description", about}};
        whole.update(schema);
        return whole;
    }

private:
    ordered_json of_section(const Section& section) {
        ordered_json schema;
        switch (section.shape) {
            case Section::Shape::map:
                schema = of_map(section);
                break;
            case Section::Shape::list_of_maps:
                schema = {{"type", "array"}, {"items", of_map(section)}};
                break;
            case Section::Shape::list_of_words:
                schema = {{"type", "array"}, {"items", of_columns()}, {"minItems", 1}};
                break;
        }
        schema["description"] = section.meaning;
        return schema;
    }

    ordered_json of_map(const Section& section) {
        ordered_json schema = map_schema(section.keys);
        if (section.role) choose_plugin(section, schema);
        if (section.part != nullptr) schema["properties"][section.part->key] = of_section(*section.part);
        if (&section == &core::needle_section) schema["allOf"].push_back(radii_rule());
        return schema;
    }

    /// Adds `type`, and what each of its values asks for.
    void choose_plugin(const Section& section, ordered_json& schema) {
        const ordered_json beside = schema["properties"];
        ordered_json names = ordered_json::array(), summaries = ordered_json::array();
        schema["allOf"] = ordered_json::array();
        for (const Descriptor* plugin : plugins_) {
            if (plugin->role != *section.role) continue;
            names.push_back(plugin->name);
            summaries.push_back(plugin->about.summary);
            if (section.swappable) {
                add_within(*plugin, schema);
            } else {
                schema["allOf"].push_back(if_type(plugin->name, define(*plugin, map_beside(*plugin, beside))));
            }
        }
        put_first("type", {{"enum", names}, {"enumDescriptions", summaries}, {"description", "the plugin's name"}}, schema);
        if (!section.swappable) schema.erase("additionalProperties");    // each plugin's definition has its own
        if (schema["allOf"].empty()) schema.erase("allOf");              // draft 7 wants one at least
    }

    /// A required key in front of the others.
    static void put_first(const char* key, const ordered_json& value, ordered_json& schema) {
        ordered_json properties{{key, value}};
        properties.update(schema["properties"]);
        schema["properties"] = properties;
        schema["required"].insert(schema["required"].begin(), key);
    }

    /// Of a swappable section: the plugin's map may always be there, and must be where `type` names the plugin and it asks for
    /// it.
    void add_within(const Descriptor& plugin, ordered_json& schema) {
        schema["properties"][plugin.name] = define(plugin, own_map(plugin));
        if (asks_for_its_map(plugin)) schema["allOf"].push_back(if_type(plugin.name, {{"required", {plugin.name}}}));
    }

    static ordered_json own_map(const Descriptor& plugin) {
        return map_schema(parameters_of(plugin), fmt::format("{}: {}", plugin.name, plugin.about.source));
    }

    /// The plugin's keys in the section's map, which holds `type` and the section's own keys, too.
    static ordered_json map_beside(const Descriptor& plugin, const ordered_json& section_keys) {
        ordered_json map = own_map(plugin);
        map["properties"]["type"] = true;
        for (const auto& [key, schema] : section_keys.items()) map["properties"][key] = true;
        return map;
    }

    /// A reference to what is then defined.
    ordered_json define(const Descriptor& plugin, ordered_json map) {
        map["description"] = fmt::format("{}\n\n{}", plugin.about.summary, plugin.about.source);
        definitions_[plugin.name] = std::move(map);
        return {{"$ref", fmt::format("#/definitions/{}", plugin.name)}};
    }

    static bool asks_for_its_map(const Descriptor& plugin) {
        return std::ranges::any_of(parameters_of(plugin),
                                   [](const Parameter& parameter) { return parameter.need == Need::required; });
    }

    static ordered_json if_type(const char* name, const ordered_json& then) {
        return {{"if", {{"properties", {{"type", {{"const", name}}}}}, {"required", {"type"}}}}, {"then", then}};
    }

    static ordered_json of_columns() {
        ordered_json words = ordered_json::array(), meanings = ordered_json::array();
        for (const std::string& word : core::record_words()) {
            words.push_back(word);
            const core::Column* column = core::column_named(word);    // or a group of them
            meanings.push_back(column == nullptr ? "every column of the energy ledger"
                                                 : fmt::format("[{}] {}", column->unit, column->meaning));
        }
        return {{"enum", words}, {"enumDescriptions", meanings}};
    }

    /// A gauge or radii, as read_needle (core/scene/needle_section.cpp) has it.
    static ordered_json radii_rule() {
        return {{"if", {{"required", {"gauge"}}}},
                {"then", {{"properties", {{"radius", false}, {"inner_radius", false}}}}},
                {"else", {{"required", {"radius"}}}}};
    }

    /// What the sections ask of each other, as check_sections (core/scene/reader.cpp) has it.
    static ordered_json presence_rules() {
        const char* const tissue = core::tissue_section.key;
        const char* const needle = core::needle_section.key;
        const char* const device = core::device_section.key;
        const char* const coupling = core::coupling_section.key;
        const auto there = [](const auto&... keys) { return ordered_json{{"required", {keys...}}}; };
        const auto absent = [&](const char* key) { return ordered_json{{"not", there(key)}}; };
        const auto none = [](const char* key) { return ordered_json{{"properties", {{key, false}}}}; };
        const auto rule = [](const ordered_json& when, const ordered_json& then) {
            return ordered_json{{"if", when}, {"then", then}};
        };
        return ordered_json::array({rule(absent(needle), there(tissue)), rule(there(tissue, needle), there(device, coupling)),
                                    rule(absent(tissue), none(coupling)), rule(absent(needle), none(coupling)),
                                    rule(absent(needle), none(device)),
                                    rule(absent(device), {{"properties", {{core::run_section.key, there("duration")}}}})});
    }

    std::vector<const Descriptor*> plugins_;
    ordered_json definitions_ = ordered_json::object();
};

}    // namespace

std::string scene_schema(std::span<const core::PluginLibrary> plugins) {
    return SceneSchema(plugins).of_scene().dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

}    // namespace stylet::app
