#include "apps/stylet/reference_loads.h"

#include "apps/stylet/failure.h"
#include "core/scene/complaints.h"
#include "core/scene/scene_files.h"
#include "core/scene/suggestion.h"

#include <stylet/error.h>

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <map>
#include <sstream>

namespace stylet::app {
namespace {

constexpr const char* header = "scene,load [N]";
constexpr std::size_t longest = 1 << 20;    // [bytes] more is no table of scenes

[[noreturn]] void refuse(const std::string& file, int line, const std::string& found, const std::string& wanted) {
    throw Failure(ExitCode::wrong_input, fmt::format("{}:{}: found {}, wanted {}", file, line, core::quote(found), wanted));
}

std::string bytes_of(const std::string& file) {
    try {
        return core::read_bytes(file, longest);
    } catch (const Error& error) {
        throw Failure(ExitCode::wrong_input, fmt::format("{}: {}, wanted a table of loads", file, error.what()));
    }
}

std::map<std::string, double> read_table(const std::string& file) {
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";    // spreadsheets begin UTF-8 with it
    const std::string bytes = bytes_of(file);
    std::istringstream lines(bytes.substr(bytes.starts_with(byte_order_mark) ? byte_order_mark.size() : 0));
    std::map<std::string, double> loads;
    bool headed = false;
    int number = 0;
    for (std::string line; std::getline(lines, line);) {
        ++number;
        if (line.ends_with('\r')) line.pop_back();
        if (line.empty() || line.front() == '#') continue;
        if (!headed && line != header) refuse(file, number, line, fmt::format("the header '{}'", header));
        if (!std::exchange(headed, true)) continue;
        const std::size_t comma = line.find(',');
        double load = 0.0;
        const char* const end = line.data() + line.size();
        const bool split = comma != std::string::npos && comma > 0;
        const auto [stop, error] = std::from_chars(split ? line.data() + comma + 1 : end, end, load);
        if (error != std::errc{} || stop != end || !std::isfinite(load) || load <= 0.0)
            refuse(file, number, line, "a scene's name and its load in N, such as fig3,0.314");
        if (!loads.emplace(line.substr(0, comma), load).second) refuse(file, number, line, "each scene once");
    }
    if (!headed) refuse(file, 1, "", fmt::format("the header '{}'", header));
    return loads;
}

}    // namespace

void add_references(const std::string& file, CriticalLoads& loads) {
    const std::map<std::string, double> known = read_table(file);
    std::vector<std::string> names;
    for (const auto& [name, load] : known) names.push_back(name);
    std::vector<std::string> missing;
    for (SceneLoads& scene : loads.scenes) {
        const auto found = known.find(scene.name);
        if (found == known.end()) {
            missing.push_back(scene.name);
        } else {
            scene.reference = found->second;
        }
    }
    if (missing.empty()) return;
    std::vector<std::string> quoted;
    std::ranges::transform(missing, std::back_inserter(quoted), core::quote);
    const std::string suggested = missing.size() == 1 ? core::suggestion(missing.front(), names) : "";
    throw Failure(ExitCode::wrong_input,
                  fmt::format("{}: found no load of {}, wanted one for each scene{}", file, fmt::join(quoted, ", "), suggested));
}

}    // namespace stylet::app
