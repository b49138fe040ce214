#include "core/loading/plugin_folders.h"

#include <boost/dll/runtime_symbol_info.hpp>

#include <algorithm>
#include <cstdlib>
#include <set>
#include <sstream>

namespace stylet::core {
namespace {

namespace fs = std::filesystem;

constexpr const char* extension = ".so";

}    // namespace

bool is_plain_name(const std::string& type) {
    const auto plain = [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_'; };
    return !type.empty() && std::ranges::all_of(type, plain);
}

PluginFolders PluginFolders::standard(const std::vector<fs::path>& given) {
    std::vector<fs::path> folders = given;
    if (const char* environment = std::getenv("STYLET_PLUGIN_PATH")) {
        std::istringstream stream(environment);
        for (std::string folder; std::getline(stream, folder, ':');) {
            if (!folder.empty()) folders.emplace_back(folder);
        }
    }
    const fs::path program = boost::dll::program_location().string();
    folders.push_back(program.parent_path().parent_path() / "lib" / "stylet" / "plugins");
    return PluginFolders(std::move(folders));
}

std::optional<fs::path> PluginFolders::find(const std::string& type) const {
    if (!is_plain_name(type)) return std::nullopt;
    for (const fs::path& folder : folders_) {
        const fs::path file = folder / (type + extension);
        std::error_code error;
        if (fs::is_regular_file(file, error)) return file;
    }
    return std::nullopt;
}

std::vector<std::string> PluginFolders::names() const {
    std::set<std::string> names;
    for (const fs::path& folder : folders_) {
        std::error_code error;
        for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
            const std::string name = entry->path().stem().string();
            if (entry->path().extension() == extension && is_plain_name(name)) names.insert(name);
        }
    }
    return {names.begin(), names.end()};
}

}    // namespace stylet::core
