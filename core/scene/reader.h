// YAML → Scene. The only door to yaml-cpp and UDUNITS.
#pragma once

#include "core/loading/plugin_folders.h"
#include "core/scene/scene.h"

#include <stdexcept>
#include <string>
#include <vector>

namespace stylet::core {

/// All that is wrong with a scene, one sentence each: `file:line:col: path: what was found, what was wanted (meaning); did you
/// mean …?`
class SceneErrors : public std::runtime_error {
public:
    explicit SceneErrors(std::vector<std::string> messages);
    [[nodiscard]] const std::vector<std::string>& messages() const { return messages_; }

private:
    std::vector<std::string> messages_;
};

/// `--set key=value`: a dotted path with list indices in brackets (effects[0].rupture_force) and a value in YAML. Or the key, or
/// the list's item, is taken out, as if the scene had not said it; the items after it keep their indices for other overrides.
struct Override {
    std::string key;
    std::string value;
    std::string given = "--set " + key;    // by the user, as errors name it
    bool makes_way = false;                // maps on the way to the key that the scene leaves out are made
    bool removes = false;                  // `value` says nothing then
};

/// Reads and checks a scene against the declarations of the plugins it names. Throws SceneErrors.
[[nodiscard]] Scene read_scene(const std::filesystem::path& file, const std::vector<Override>& overrides,
                               const PluginFolders& folders);

/// The title alone, for a list of scenes; empty where there is none, and of a study.
[[nodiscard]] std::string scene_title(const std::filesystem::path& file);

/// Whether the file holds a study; false where it cannot be read.
[[nodiscard]] bool holds_study(const std::filesystem::path& file);

}    // namespace stylet::core
