#include "apps/stylet/puncture_force.h"

#include "core/loading/loaded.h"

#include <stylet/force_model.h>

#include <limits>

namespace stylet::app {

constexpr double infinity = std::numeric_limits<double>::infinity();

double puncture_force(const core::Scene& scene, const core::PluginFolders& folders) {
    if (!scene.tissue) return infinity;
    const Contact tip{.tip = true,
                      .inside = false,
                      .layer = 0,
                      .coverage = 0.0,
                      .axial_force = 0.0,
                      .slip = 0.0,
                      .slipping = false,
                      .needle_radius = scene.needle_setup->radius,
                      .axis = -Vector3::UnitZ(),
                      .time = 0.0};
    ContactLaw law;
    for (const core::Choice& choice : scene.effects) {
        core::Loaded<ForceModel> effect(scene, choice, folders);
        law = effect.ask([&](const ForceModel& model) {
            ContactLaw with = law;
            model.add_to(tip, with);
            return with;
        });
    }
    return law.tip_limited ? law.tip_limit : infinity;
}

}    // namespace stylet::app
