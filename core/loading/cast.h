// The objects of a scene. Members are declared so that objects go before the libraries that their code lives in.
#pragma once

#include <stylet/buckling_model.h>
#include <stylet/force_model.h>
#include <stylet/haptic_device.h>
#include <stylet/needle_model.h>
#include <stylet/tissue_model.h>

#include "core/loading/plugin_library.h"
#include "core/scene/scene.h"

#include <memory>
#include <vector>

namespace stylet::core {

struct Maker;

/// Everything that acts in a scene, loaded and made. Nothing that the scene does not name is in it.
class Cast {
public:
    /// The objects refer to the scene's setups and parameters, and may borrow `workers`: both must outlive the cast. Throws
    /// SceneErrors, with the scene's line for each, where a library is refused or a constructor throws.
    Cast(const Scene& scene, const PluginFolders& folders, Workers& workers = one_thread());

    // Assigning members one by one would close libraries before the objects that live in them are gone.
    Cast(const Cast&) = delete;
    Cast& operator=(const Cast&) = delete;

    // Of what the scene doesn't name, a stand-in of core's own (absent.h).
    [[nodiscard]] TissueModel& tissue() const { return *tissue_; }
    [[nodiscard]] NeedleModel& needle() const { return *needle_; }
    [[nodiscard]] HapticDevice& device() const { return *device_; }
    [[nodiscard]] const std::vector<std::unique_ptr<ForceModel>>& effects() const { return effects_; }

    /// The files of the libraries in use, in the order of loading.
    [[nodiscard]] std::vector<std::filesystem::path> libraries() const;

private:
    void load_patches(Maker& maker);

    std::vector<PluginLibrary> libraries_;
    std::unique_ptr<BucklingModel> buckling_;
    std::unique_ptr<TissueModel> tissue_;
    std::unique_ptr<NeedleModel> needle_;
    std::vector<std::unique_ptr<ForceModel>> effects_;
    std::unique_ptr<HapticDevice> device_;
};

}    // namespace stylet::core
