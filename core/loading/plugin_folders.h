#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace stylet::core {

/// Small letters, digits and '_': what a plugin may be called, so that no `type:` of a scene can be a path.
[[nodiscard]] bool is_plain_name(const std::string& type);

/// Where plugins are looked for, in this order: `--plugin-dir`, `STYLET_PLUGIN_PATH`, the install's own folder. A scene can add
/// none. Looked up by file name (<type>.so), never by listing a folder: what else lies there costs a run nothing.
class PluginFolders {
public:
    explicit PluginFolders(std::vector<std::filesystem::path> folders) : folders_(std::move(folders)) {}

    /// `given` first, then the environment's (separated by ':'), then <executable>/../lib/stylet/plugins.
    [[nodiscard]] static PluginFolders standard(const std::vector<std::filesystem::path>& given = {});

    [[nodiscard]] std::optional<std::filesystem::path> find(const std::string& type) const;

    /// The names of all libraries in all folders, sorted: for lists and suggestions only.
    [[nodiscard]] std::vector<std::string> names() const;

    [[nodiscard]] const std::vector<std::filesystem::path>& folders() const { return folders_; }

private:
    std::vector<std::filesystem::path> folders_;
};

}    // namespace stylet::core
