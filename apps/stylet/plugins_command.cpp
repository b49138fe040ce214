#include "apps/stylet/command.h"
#include "apps/stylet/plugin_text.h"
#include "apps/stylet/scene_arguments.h"
#include "apps/stylet/table.h"
#include "core/loading/plugin_library.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

namespace stylet::app {
namespace {

constexpr const char* examples =
    R"(Without NAME, lists every plugin: its role, its name (the `type:` of a scene) and one line on it. With NAME, shows
that plugin's parameters: kind and unit, range in SI units, whether it is required, meaning; and the source it follows.
The keys that all tissues or all needles share (extent, layers, length, radius, ...) belong to the scene, not to a plugin.

Examples:
  stylet plugins
  stylet plugins friction
  stylet plugins --json
  stylet plugins my_effect --plugin-dir ~/plugins

Exit codes: 0 ok, 2 there is no such plugin or it is refused, 3 wrong command line.)";

struct PluginArguments {
    std::string name;
    std::vector<std::string> plugin_dirs;
    bool json = false;
};

ExitCode show_one(const PluginArguments& arguments) {
    const core::PluginLibrary library = core::PluginLibrary::open(arguments.name, plugin_folders(arguments.plugin_dirs));
    if (arguments.json) {
        fmt::print("{}", plugin_json(library));
        return ExitCode::ok;
    }
    fmt::print("{}", plugin_text(library));
    return ExitCode::ok;
}

/// A library that is refused is told of on stderr; the others are listed all the same.
std::vector<core::PluginLibrary> open_all(const core::PluginFolders& folders) {
    std::vector<core::PluginLibrary> libraries;
    for (const std::string& name : folders.names()) {
        try {
            libraries.push_back(core::PluginLibrary::open(name, folders));
        } catch (const Error& error) {
            fmt::print(stderr, "{}\n", error.what());
        }
    }
    std::stable_sort(libraries.begin(), libraries.end(), [](const core::PluginLibrary& left, const core::PluginLibrary& right) {
        return left.descriptor().role < right.descriptor().role;
    });
    return libraries;
}

ExitCode show_all(const PluginArguments& arguments) {
    const std::vector<core::PluginLibrary> libraries = open_all(plugin_folders(arguments.plugin_dirs));
    if (arguments.json) {
        fmt::print("{}", plugins_json(libraries));
        return ExitCode::ok;
    }
    Table table({Table::Align::left, Table::Align::left, Table::Align::left});
    for (const core::PluginLibrary& library : libraries) {
        const Descriptor& plugin = library.descriptor();
        table.add({core::name_of(plugin.role), plugin.name, plugin.about.summary});
    }
    fmt::print("{}", table.text(0));
    return ExitCode::ok;
}

}    // namespace

Command plugins_command(CLI::App& line) {
    const auto arguments = std::make_shared<PluginArguments>();
    CLI::App* options = line.add_subcommand("plugins", "List the plugins, or show one's parameters");
    options->footer(examples);
    options->add_option("NAME", arguments->name, "Show this plugin's parameters")->type_name("");
    options->add_flag("--json", arguments->json, "The same as JSON");
    add_plugin_dir(*options, arguments->plugin_dirs);
    return {options, [arguments] { return arguments->name.empty() ? show_all(*arguments) : show_one(*arguments); }};
}

}    // namespace stylet::app
