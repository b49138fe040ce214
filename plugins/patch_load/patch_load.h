#pragma once

#include <stylet/force_model.h>
#include <stylet/ramp.h>

namespace stylet::patch_load {

/// A force on a patch of the tissue's surface, whatever the tissue does.
///
///     F(t) = s(t) F        s: a step at time 0, or min(t/ramp, 1)        (F [N] in world coordinates, t [s])
///
/// The patch is what of the undeformed surface lies in the box of `size` [m] around `centre` [m]; a side of no length is a plane.
/// The tissue shares the force evenly over what the patch covers. Source: the constant traction of a static test (Love 1929, for
/// a rectangle). Valid as far as the tissue's model is. A dead load: neither its direction nor the patch follows the deformed
/// surface. Throws Error where the scene has no tissue, or a side is negative.
class PatchLoad final : public ForceModel {
public:
    explicit PatchLoad(const Setup& setup);

    const Patch* patch() const override { return &patch_; }
    Vector3 patch_force(double time) const override { return ramp_.share(time) * force_; }

private:
    Patch patch_;
    Vector3 force_;    // [N] once all of it acts
    Ramp ramp_;
};

}    // namespace stylet::patch_load
