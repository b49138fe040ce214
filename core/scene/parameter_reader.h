// Reads the keys of a scene's maps against their declarations. A plugin's parameters and core's own keys are declared alike.
#pragma once

#include "core/scene/complaints.h"
#include "core/scene/scene_files.h"
#include "core/scene/value_tree.h"

#include "core/loading/plugin_folders.h"

#include <stylet/parameters.h>

#include <map>
#include <span>

namespace stylet::core {

/// What reading one scene gathers and looks things up in.
struct Reading {
    SceneFiles files;
    const PluginFolders& folders;
    Complaints complaints{};
    std::map<std::string, Place> places{};    // of every value read, by its path
};

/// True of a map; complains of anything else, with the map's meaning.
[[nodiscard]] bool is_map(const ValueTree& node, const std::string& path, const std::string& meaning, Reading& reading);

/// Reads each declared key that `map` gives, and complains of each value that is not as declared and each required one that is
/// missing.
[[nodiscard]] Parameters read_parameters(const ValueTree& map, const std::string& path, std::span<const Parameter> declared,
                                         Reading& reading);

/// Complains of each key of `map` that is not `known`.
void refuse_unknown_keys(const ValueTree& map, const std::string& path, const std::vector<std::string>& known, Reading& reading);

/// Complains of one; `wanted` says what may stand there instead, `candidates` what it may have been meant to be.
void refuse_unknown_key(const ValueTree::Entry& entry, const std::string& path, const std::string& wanted,
                        const std::vector<std::string>& candidates, Reading& reading);

/// Complains of a key that is not there; `wanted` says what should be.
void miss_key(const ValueTree& map, const std::string& path, const std::string& wanted, Reading& reading);

[[nodiscard]] std::vector<std::string> names_of(std::span<const Parameter> declared);

/// The value where it was given and well read, else NaN, which every further comparison leaves uncomplained of.
[[nodiscard]] double number_or_nan(const Parameters& parameters, std::string_view name);

}    // namespace stylet::core
