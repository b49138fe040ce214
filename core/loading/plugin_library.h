#pragma once

#include <stylet/plugin.h>

#include "core/loading/plugin_folders.h"

#include <memory>
#include <string>

namespace stylet::core {

/// A plugin's library, open as long as this lives. Whatever it created must go first.
class PluginLibrary {
public:
    /// Finds and opens <type>.so and checks its descriptor before anything else of it is called. Throws Error with one sentence
    /// that says what differs: not found (with a suggestion and the folders searched), not a library, no descriptor, another SDK
    /// version, compiler, standard library, Eigen version or alignment, descriptor size, or a name that is not the file's.
    [[nodiscard]] static PluginLibrary open(const std::string& type, const PluginFolders& folders);

    /// The same, and also refuses a plugin of another role.
    [[nodiscard]] static PluginLibrary open(const std::string& type, Role role, const PluginFolders& folders);

    PluginLibrary(PluginLibrary&&) noexcept;
    PluginLibrary& operator=(PluginLibrary&&) noexcept;
    ~PluginLibrary();

    [[nodiscard]] const Descriptor& descriptor() const;
    [[nodiscard]] const std::filesystem::path& file() const;

private:
    class Handle;
    explicit PluginLibrary(std::unique_ptr<Handle> handle);
    std::unique_ptr<Handle> handle_;
};

/// "tissue", "needle", … as a sentence needs them.
[[nodiscard]] const char* name_of(Role role);
/// "a tissue", "an effect", …
[[nodiscard]] std::string with_article(Role role);

}    // namespace stylet::core
