#pragma once

#include "core/loading/loaded.h"

#include <stylet/force_model.h>

#include <memory>
#include <vector>

namespace stylet::app {

/// The force that takes the scene's needle in at a right angle, by what its effects say of tip and shaft.
class InsertionForce {
public:
    /// Refers to the scene, which must outlive it. Throws core::SceneErrors where an effect is refused.
    InsertionForce(const core::Scene& scene, const core::PluginFolders& folders);

    /// [N] at which the tip on the surface punctures it; infinite where nothing lets it in.
    [[nodiscard]] double puncture();

    /// [N] at which the needle goes on inside, this much of it [m] in the tissue: what the tip cuts at, and the friction of the
    /// shaft as it sets out from rest. Infinite where the tip has come to a layer that no effect lets it into.
    [[nodiscard]] double inside(double inserted);

private:
    void add(const Contact& contact, ContactLaw& law);

    const core::Scene& scene_;
    std::vector<std::unique_ptr<core::Loaded<ForceModel>>> effects_;
};

}    // namespace stylet::app
