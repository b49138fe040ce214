#include "core/loading/cast.h"

#include "core/loading/absent.h"
#include "core/loading/maker.h"

#include <cmath>
#include <utility>

namespace stylet::core {

namespace {

/// What a device says of itself is what keeps a hand safe.
void check_limits(const Choice& choice, const HapticDevice& device, Maker& maker) {
    maker.guard(choice, [&] {
        const DeviceLimits limits = device.limits();
        for (const auto& [name, limit] : {std::pair{"force", limits.force},
                                          {"moment", limits.moment},
                                          {"force_rate", limits.force_rate},
                                          {"soft_start", limits.soft_start},
                                          {"stale_after", limits.stale_after},
                                          {"ramp_down", limits.ramp_down}}) {
            if (std::isfinite(limit) && limit > 0.0) continue;
            throw Error("the plugin '" + choice.type + "' states a limit '" + name + "' of " + std::to_string(limit) +
                        ", wanted one that is positive and finite");
        }
        if (!(device.duration() >= 0.0)) throw Error("the plugin '" + choice.type + "' states a duration below zero");
    });
}

}    // namespace

Cast::Cast(const Scene& scene, const PluginFolders& folders, Workers& workers) {
    Maker maker{.scene = scene, .folders = folders, .workers = workers, .libraries = libraries_};
    if (scene.buckling) buckling_ = maker.make<BucklingModel>(*scene.buckling, nullptr);
    tissue_ = scene.tissue ? maker.make<TissueModel>(*scene.tissue, nullptr) : std::make_unique<Air>();
    // Made without the buckling model that its scene names, a needle could only complain of what is not the scene's fault.
    const bool buckling_failed = scene.buckling && !buckling_;
    if (!scene.needle)
        needle_ = std::make_unique<NoNeedle>();
    else if (!buckling_failed)
        needle_ = maker.make<NeedleModel>(*scene.needle, buckling_.get());
    for (const Choice& effect : scene.effects) effects_.push_back(maker.make<ForceModel>(effect, nullptr));
    device_ = scene.device
                  ? maker.make<HapticDevice>(*scene.device, nullptr)
                  : std::make_unique<StillHand>(scene.needle_setup ? scene.needle_setup->length : StillHand::out_of_the_way);
    if (scene.device && device_) check_limits(*scene.device, *device_, maker);
    if (tissue_) load_patches(maker);
    maker.complaints.throw_if_any();
}

// A tissue refuses one patch at a time: each is tried alone first, so that its effect's line is named.
void Cast::load_patches(Maker& maker) {
    std::vector<Patch> patches;
    const Choice* last = nullptr;
    for (std::size_t i = 0; i < effects_.size(); ++i) {
        const Choice& choice = maker.scene.effects[i];
        maker.guard(choice, [&] {
            const Patch* patch = effects_[i] ? effects_[i]->patch() : nullptr;
            if (patch == nullptr) return;
            tissue_->bear({patch, 1});
            patches.push_back(*patch);
            last = &choice;
        });
    }
    if (last != nullptr) maker.guard(*last, [&] { tissue_->bear(patches); });
}

std::vector<std::filesystem::path> Cast::libraries() const {
    std::vector<std::filesystem::path> files;
    for (const PluginLibrary& library : libraries_) files.push_back(library.file());
    return files;
}

}    // namespace stylet::core
