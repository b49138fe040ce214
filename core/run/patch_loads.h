#pragma once

#include <stylet/force_model.h>
#include <stylet/tissue_model.h>

#include <memory>
#include <span>
#include <vector>

namespace stylet::core {

/// The loads that effects prescribe to patches of the tissue's surface: hands them to the tissue and knows the work they do.
class PatchLoads {
public:
    PatchLoads(std::span<const std::unique_ptr<ForceModel>> effects, TissueModel& tissue) : tissue_(tissue) {
        for (const auto& effect : effects) {
            if (effect->patch() != nullptr) loads_.push_back({.effect = effect.get()});
        }
        forces_.resize(loads_.size(), Vector3::Zero());
    }

    /// Before the tissue is predicted: what acts at the end of the step, at `time` [s].
    void apply(double time) {
        if (loads_.empty()) return;
        for (std::size_t i = 0; i < loads_.size(); ++i) forces_[i] = loads_[i].effect->patch_force(time);
        tissue_.load(forces_);
    }

    /// The contacts have moved on in the tissue, and the patches with them.
    void note_carried() {
        for (int i = 0; i < count(); ++i) loads_[i].carried = tissue_.patch_displacement(i) - loads_[i].displacement;
    }

    /// [J] that the step did, in the tissue's latest trial state, by the trapezoid rule.
    [[nodiscard]] double work() const {
        double work = 0.0;
        for (int i = 0; i < count(); ++i) work += mean_force(i).dot(tissue_.patch_displacement(i) - loads_[i].displacement);
        return work;
    }

    /// [J] of that, what was done because contacts had moved on.
    [[nodiscard]] double work_carried() const {
        double work = 0.0;
        for (int i = 0; i < count(); ++i) work += mean_force(i).dot(loads_[i].carried);
        return work;
    }

    /// The tissue has committed.
    void commit() {
        for (int i = 0; i < count(); ++i) {
            loads_[i].force = forces_[i];
            loads_[i].displacement = tissue_.patch_displacement(i);
        }
    }

    [[nodiscard]] int count() const { return static_cast<int>(loads_.size()); }
    [[nodiscard]] const Vector3& force(int i) const { return loads_[i].force; }                  // [N] at the last commit
    [[nodiscard]] const Vector3& displacement(int i) const { return loads_[i].displacement; }    // [m] mean, then

private:
    struct Load {
        const ForceModel* effect;
        Vector3 force = Vector3::Zero();           // [N]
        Vector3 displacement = Vector3::Zero();    // [m]
        Vector3 carried = Vector3::Zero();         // [m]
    };

    [[nodiscard]] Vector3 mean_force(int i) const { return 0.5 * (loads_[i].force + forces_[i]); }

    TissueModel& tissue_;
    std::vector<Load> loads_;
    std::vector<Vector3> forces_;    // [N] of the step in hand
};

}    // namespace stylet::core
