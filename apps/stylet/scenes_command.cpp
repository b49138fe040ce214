#include "apps/stylet/command.h"
#include "apps/stylet/failure.h"
#include "apps/stylet/table.h"
#include "core/scene/reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

namespace stylet::app {
namespace {

namespace fs = std::filesystem;

constexpr const char* examples =
    R"(Lists the scenes that come with stylet, each with its title. Copy one and change it, or run it as it is.

Example:
  stylet scenes

Exit codes: 0 ok, 3 wrong command line, 4 the prepared scenes are not where the install puts them.)";

/// The same place beside the executable in a build tree and in an install.
fs::path scene_folder() {
    const fs::path folder = fs::read_symlink("/proc/self/exe").parent_path().parent_path() / "share/stylet/scenes";
    std::error_code failed;
    const fs::path real = fs::canonical(folder, failed);
    if (failed) {
        throw Failure(ExitCode::missing, fmt::format("{}: the prepared scenes are not there, wanted a folder", folder.string()));
    }
    return real;
}

std::string as_typed_from_here(const fs::path& file) {
    const std::string near = file.lexically_proximate(fs::current_path()).string();
    return near.starts_with("../..") ? file.string() : near;
}

ExitCode list_scenes() {
    std::vector<fs::path> files;
    for (const auto& entry : fs::recursive_directory_iterator(scene_folder())) {
        if (entry.is_regular_file() && entry.path().extension() == ".yaml") files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    Table table({Table::Align::left, Table::Align::left});
    for (const fs::path& file : files) {
        const std::string title = core::scene_title(file);
        if (!title.empty()) table.add({as_typed_from_here(file), title});
    }
    fmt::print("{}", table.text(0));
    return ExitCode::ok;
}

}    // namespace

Command scenes_command(CLI::App& line) {
    CLI::App* options = line.add_subcommand("scenes", "List the prepared scenes with their titles");
    options->footer(examples);
    return {options, list_scenes};
}

}    // namespace stylet::app
