#include "apps/stylet/insertion_force.h"

#include <limits>

namespace stylet::app {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

Contact contact(const core::Scene& scene, int layer) {
    return {.tip = true,
            .inside = true,
            .layer = layer,
            .coverage = 0.0,
            .axial_force = 0.0,
            .slip = 0.0,
            .slipping = false,
            .needle_radius = scene.needle_setup->radius,
            .axis = -Vector3::UnitZ(),
            .time = 0.0};
}

double tip_limit(const ContactLaw& law) {
    return law.tip_limited ? law.tip_limit : infinity;
}

}    // namespace

InsertionForce::InsertionForce(const core::Scene& scene, const core::PluginFolders& folders) : scene_(scene) {
    if (!scene.tissue_setup) return;
    for (const core::Choice& choice : scene.effects)
        effects_.push_back(std::make_unique<core::Loaded<ForceModel>>(scene, choice, folders));
}

void InsertionForce::add(const Contact& contact, ContactLaw& law) {
    for (const auto& effect : effects_) {
        law = effect->ask([&](const ForceModel& model) {
            ContactLaw with = law;
            model.add_to(contact, with);
            return with;
        });
    }
}

double InsertionForce::puncture() {
    ContactLaw law;
    Contact tip = contact(scene_, 0);
    tip.inside = false;
    add(tip, law);
    return tip_limit(law);
}

double InsertionForce::inside(double inserted) {
    if (!scene_.tissue_setup) return infinity;
    const std::vector<Layer>& layers = scene_.tissue_setup->layers;
    ContactLaw law;
    double left = inserted;    // [m] from the top of the layer down to the tip
    for (std::size_t i = 0; i < layers.size(); ++i) {
        const bool last = i + 1 == layers.size() || left <= layers[i].thickness;
        Contact shaft = contact(scene_, static_cast<int>(i));
        shaft.tip = false;
        shaft.coverage = last ? left : layers[i].thickness;
        add(shaft, law);
        if (last) {
            add(contact(scene_, static_cast<int>(i)), law);
            break;
        }
        left -= layers[i].thickness;
    }
    return tip_limit(law) + law.axial_limit;
}

}    // namespace stylet::app
