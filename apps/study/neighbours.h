// The scenes beside a scene: other models, one step coarser or finer, one thing left out.
#pragma once

#include "core/loading/plugin_folders.h"
#include "core/scene/reader.h"

#include <optional>
#include <string>
#include <vector>

namespace stylet::study {

/// A scene that is another one but for a few changes; none: that one itself.
struct Neighbour {
    std::string name;    // "half_space, beam_column, euler", or "needle.rod.nodes=81"
    std::vector<core::Override> changes;
};

/// One that is none, because of `why`.
struct LeftOut {
    std::string name;
    std::string why;
};

struct Neighbours {
    std::vector<Neighbour> models;    // every combination of them; the first is the scene itself
    std::vector<Neighbour> steps;     // of each parameter of the scene that comes in them, one coarser and one finer
    std::vector<LeftOut> left_out;
};

/// A scene file with what was changed in it, and where its plugins are.
struct ChangedScene {
    std::filesystem::path file;
    std::vector<core::Override> changes;
    const core::PluginFolders& folders;

    /// Throws core::SceneErrors.
    [[nodiscard]] core::Scene read(const std::vector<core::Override>& more = {}) const;
};

/// For tissue, needle and the needle's buckling (where it asks for a load): the scene's own model, those that its section holds a
/// map for, and every plugin of the role that needs no parameters. Models are loaded once each, so that those that refuse this
/// scene are left out. Throws core::SceneErrors where the scene itself is wrong.
[[nodiscard]] Neighbours neighbours_of(const ChangedScene& base);

/// Every number one step finer at once, but for the rate: how many ticks a second has is the scene's to say. Words stay: another
/// method may take a hundred times as long.
[[nodiscard]] std::vector<core::Override> finest_step(const core::Scene& scene, const core::PluginFolders& folders);

/// What to mind where a tissue alone is loaded by what its mesh shares out: other cells bear another load. Nothing elsewhere.
[[nodiscard]] std::optional<std::string> load_by_mesh(const core::Scene& scene, const core::PluginFolders& folders);

/// The scene without each effect, without its needle's buckling, and without each optional quantity of its models that switches
/// off what it stands for. Whether a scene is left, its reader tells.
[[nodiscard]] std::vector<Neighbour> omissions(const core::Scene& scene, const core::PluginFolders& folders);

/// The needle asks the buckling model that it is given.
[[nodiscard]] bool asks_for_load(const core::Scene& scene, const core::PluginFolders& folders);

}    // namespace stylet::study
