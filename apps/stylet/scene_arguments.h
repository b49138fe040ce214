// What every command that reads scenes is given.
#pragma once

#include "core/loading/plugin_folders.h"
#include "core/scene/reader.h"

#include <CLI/App.hpp>

#include <optional>
#include <string>
#include <vector>

namespace stylet::app {

struct KeyValue {
    std::string key, value;
};

/// "needle.type=rod" at its first '='; nothing where there is none or no key before it.
[[nodiscard]] std::optional<KeyValue> read_key_value(const std::string& text);

void add_plugin_dir(CLI::App& options, std::vector<std::string>& folders);
[[nodiscard]] core::PluginFolders plugin_folders(const std::vector<std::string>& given);

/// SCENE... --set KEY=VALUE --plugin-dir DIR
class SceneArguments {
public:
    void add_to(CLI::App& options);

    [[nodiscard]] const std::vector<std::string>& files() const { return files_; }
    [[nodiscard]] core::PluginFolders folders() const { return plugin_folders(plugin_dirs_); }

    /// Throws Failure where an argument of --set has no '='.
    [[nodiscard]] std::vector<core::Override> overrides() const;

private:
    std::vector<std::string> files_;
    std::vector<std::string> set_;
    std::vector<std::string> plugin_dirs_;
};

}    // namespace stylet::app
