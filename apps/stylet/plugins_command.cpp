#include "apps/stylet/command.h"
#include "apps/stylet/output.h"
#include "apps/stylet/plugin_list.h"
#include "apps/stylet/plugin_page.h"
#include "apps/stylet/plugin_text.h"
#include "apps/stylet/scene_arguments.h"
#include "apps/stylet/table.h"

#include <fmt/format.h>

#include <filesystem>
#include <memory>

namespace stylet::app {
namespace {

constexpr const char* examples =
    R"(Without NAME, lists every plugin: its role, its name (the `type:` of a scene) and one line on it. With NAME, shows
that plugin's formula, source and validity, and its parameters: kind and unit, range in SI units, whether it is required,
meaning. With --pages, writes all that as Markdown, a page for each plugin and a README.md that lists them.
The keys that all tissues or all needles share (extent, layers, length, radius, ...) belong to the scene, not to a plugin.

Examples:
  stylet plugins
  stylet plugins friction
  stylet plugins --json
  stylet plugins my_effect --plugin-dir ~/plugins
  stylet plugins --pages docs/plugins

Exit codes: 0 ok, 2 there is no such plugin or it is refused, 3 wrong command line, 4 a page cannot be written.)";

struct PluginArguments {
    std::string name;
    std::string pages;
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

ExitCode show_all(const PluginArguments& arguments) {
    const std::vector<core::PluginLibrary> libraries = all_plugins(plugin_folders(arguments.plugin_dirs));
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

ExitCode write_pages(const PluginArguments& arguments) {
    const std::vector<core::PluginLibrary> libraries = all_plugins(plugin_folders(arguments.plugin_dirs));
    const std::filesystem::path folder = arguments.pages;
    const auto write = [&](const std::string& name, const std::string& text) {
        write_file(folder / name, text);
        fmt::print("{}\n", (folder / name).string());
    };
    make_folder(folder);
    write("README.md", plugin_index(libraries));
    for (const core::PluginLibrary& library : libraries) {
        const Descriptor& plugin = library.descriptor();
        write(std::string(plugin.name) + ".md", plugin_page(plugin));
    }
    return ExitCode::ok;
}

}    // namespace

Command plugins_command(CLI::App& line) {
    const auto arguments = std::make_shared<PluginArguments>();
    CLI::App* options = line.add_subcommand("plugins", "List the plugins, or show one's parameters");
    options->footer(examples);
    CLI::Option* name = options->add_option("NAME", arguments->name, "Show this plugin's parameters")->type_name("");
    CLI::Option* json = options->add_flag("--json", arguments->json, "The same as JSON");
    options->add_option("--pages", arguments->pages, "Write a Markdown page for each plugin into this folder")
        ->type_name("FOLDER")
        ->excludes(name)
        ->excludes(json);
    add_plugin_dir(*options, arguments->plugin_dirs);
    return {options, [arguments] {
                if (!arguments->pages.empty()) return write_pages(*arguments);
                return arguments->name.empty() ? show_all(*arguments) : show_one(*arguments);
            }};
}

}    // namespace stylet::app
