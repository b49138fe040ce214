// The changes to a scene that a study writes down: `set`, `leave_out`, `vary` and what is drawn at random.
#pragma once

#include "apps/study/interval.h"
#include "apps/study/study.h"
#include "core/scene/parameter_reader.h"

namespace stylet::study {

/// What the map at `path` says under `set` (a map of the scene's keys) and `leave_out` (a list of them); what is set of one key
/// counts more than that it is left out. List items keep the numbers that the scene gives them.
[[nodiscard]] std::vector<core::Override> read_changes(const core::ValueTree& map, const std::string& path,
                                                       core::Reading& reading);

/// What it says under `vary`; none where it says nothing.
[[nodiscard]] std::vector<Vary> read_varied(const core::ValueTree& map, const std::string& path, core::Reading& reading);

/// A key whose value is drawn anew for each case.
struct Draw {
    std::string key;
    Interval range{};
    Spacing spacing = Spacing::linear;
    std::vector<std::string> one_of{};    // instead of a range, each as YAML
    std::string given;

    /// Its value for a number that is drawn from 0 up to 1.
    [[nodiscard]] core::Override at(double share) const;
};
[[nodiscard]] std::vector<Draw> read_draws(const core::ValueTree& map, const std::string& path, core::Reading& reading);

/// The keys beside a map's declared ones that these functions read.
inline constexpr const char* set_key = "set";
inline constexpr const char* leave_out_key = "leave_out";
inline constexpr const char* vary_key = "vary";

/// The tree as one line of YAML.
[[nodiscard]] std::string yaml_text(const core::ValueTree& tree);

}    // namespace stylet::study
