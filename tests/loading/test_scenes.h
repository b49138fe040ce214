// A scene in a folder of its own, the tests' plugins, and what a reader complains of.
#pragma once

#include "core/scene/reader.h"

#include <fstream>
#include <sstream>

namespace stylet::core {

inline PluginFolders good_plugins() {
    return PluginFolders({GOOD_PLUGINS});
}
inline PluginFolders bad_plugins() {
    return PluginFolders({BAD_PLUGINS});
}

inline std::filesystem::path good_scene() {
    return std::filesystem::path(SCENES) / "good.yaml";
}

inline std::string contents(const std::filesystem::path& file) {
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    return text.str();
}

/// What the good scene is refused for under these overrides; empty where it is not.
inline std::vector<std::string> complaints(const std::vector<Override>& overrides) {
    try {
        (void)read_scene(good_scene(), overrides, good_plugins());
        return {};
    } catch (const SceneErrors& errors) {
        return errors.messages();
    }
}

using Messages = std::vector<std::string>;

/// Whether a library of that name is mapped into this process.
inline bool is_mapped(const std::string& library) {
    return contents("/proc/self/maps").find("/" + library + ".so") != std::string::npos;
}

}    // namespace stylet::core
