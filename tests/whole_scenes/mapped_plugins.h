// What a scene does not name is not in the process.
#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace stylet::whole_scenes {

/// The build's plugins that are mapped into this process, by name.
[[nodiscard]] inline std::vector<std::string> mapped_plugins() {
    std::vector<std::string> names;
    std::ifstream maps("/proc/self/maps");
    for (std::string line; std::getline(maps, line);) {
        const auto path = line.find('/');
        if (path == std::string::npos) continue;
        const std::filesystem::path file = line.substr(path);
        if (file.parent_path() != PLUGIN_FOLDER) continue;
        if (std::ranges::find(names, file.stem().string()) == names.end()) names.push_back(file.stem().string());
    }
    std::ranges::sort(names);
    return names;
}

}    // namespace stylet::whole_scenes
