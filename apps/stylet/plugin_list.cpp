#include "apps/stylet/plugin_list.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>

namespace stylet::app {

std::vector<core::PluginLibrary> all_plugins(const core::PluginFolders& folders) {
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

}    // namespace stylet::app
