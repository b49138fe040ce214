#include "apps/stylet/command.h"
#include "apps/stylet/output.h"
#include "apps/stylet/plugin_list.h"
#include "apps/stylet/scene_arguments.h"
#include "apps/stylet/schema.h"

#include <fmt/format.h>

#include <memory>

namespace stylet::app {
namespace {

constexpr const char* examples =
    R"(An editor with a YAML language server explains the keys of a scene by it and marks what is wrong while you type. A scene
names it on its first line, from where the scene lies:

  # yaml-language-server: $schema=../stylet.schema.json

It holds the plugins that there are now: write it again when you have added one.

Examples:
  stylet schema
  stylet schema --out scenes/stylet.schema.json
  stylet schema --plugin-dir ~/plugins --out stylet.schema.json

Exit codes: 0 ok, 3 wrong command line, 4 the file cannot be written.)";

struct SchemaArguments {
    std::string out;
    std::vector<std::string> plugin_dirs;
};

ExitCode show_schema(const SchemaArguments& arguments) {
    const std::string schema = scene_schema(all_plugins(plugin_folders(arguments.plugin_dirs)));
    if (arguments.out.empty()) {
        fmt::print("{}", schema);
    } else {
        write_file(arguments.out, schema);
        fmt::print("{}\n", arguments.out);
    }
    return ExitCode::ok;
}

}    // namespace

Command schema_command(CLI::App& line) {
    const auto arguments = std::make_shared<SchemaArguments>();
    CLI::App* options = line.add_subcommand("schema", "Write a JSON Schema of scenes, for editors");
    options->footer(examples);
    options->add_option("--out", arguments->out, "Write it to this file")->type_name("FILE");
    add_plugin_dir(*options, arguments->plugin_dirs);
    return {options, [arguments] { return show_schema(*arguments); }};
}

}    // namespace stylet::app
