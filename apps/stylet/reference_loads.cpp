#include "apps/stylet/reference_loads.h"

#include "apps/study/reference_files.h"
#include "apps/stylet/failure.h"
#include "core/scene/complaints.h"
#include "core/scene/suggestion.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>

namespace stylet::app {

void add_references(const std::string& file, CriticalLoads& loads) {
    const study::TableForm form{.unit = "N", .of = "scene", .quantity = "load", .above_zero = true};
    const std::map<std::string, double> known = study::table_file(file, form);
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
