#include "apps/stylet/scene_arguments.h"

#include "apps/stylet/failure.h"

#include <fmt/format.h>

namespace stylet::app {

std::optional<KeyValue> read_key_value(const std::string& text) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos || equals == 0) return std::nullopt;
    return KeyValue{.key = text.substr(0, equals), .value = text.substr(equals + 1)};
}

void add_plugin_dir(CLI::App& options, std::vector<std::string>& folders) {
    options.add_option("--plugin-dir", folders, "Look for plugins here first; may be given several times")
        ->type_name("DIR")
        ->check(CLI::Validator(CLI::ExistingDirectory).description(""))
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

core::PluginFolders plugin_folders(const std::vector<std::string>& given) {
    return core::PluginFolders::standard({given.begin(), given.end()});
}

void SceneArguments::add_to(CLI::App& options) {
    options.add_option("SCENE", files_, "Scenes to read")->required()->type_name("FILE");
    options.add_option("--set", set_, "Replace a value of the scene; may be given several times")
        ->type_name("KEY=VALUE")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    add_plugin_dir(options, plugin_dirs_);
}

std::vector<core::Override> SceneArguments::overrides() const {
    std::vector<core::Override> overrides;
    for (const std::string& text : set_) {
        const auto change = read_key_value(text);
        if (!change) {
            throw Failure(ExitCode::wrong_command,
                          fmt::format("--set: found \"{}\", wanted KEY=VALUE, for instance needle.length='180 mm'", text));
        }
        overrides.push_back({change->key, change->value});
    }
    return overrides;
}

}    // namespace stylet::app
