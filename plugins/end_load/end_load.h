#pragma once

#include <stylet/force_model.h>
#include <stylet/ramp.h>

namespace stylet::end_load {

/// A force on the tip of a needle that is alone, in air.
///
///     F(t) = s(t) F        s: a step at time 0, or min(t/ramp, 1)        (F [N] in world coordinates, t [s])
///
/// Source: the end load of Euler 1757. Valid as far as the needle's model is. A dead load: its direction doesn't follow the tip.
/// Throws Error where the scene has a tissue, or no needle.
class EndLoad final : public ForceModel {
public:
    explicit EndLoad(const Setup& setup);

    void add_to(const Contact& contact, ContactLaw& law) const override;

private:
    Vector3 force_;    // [N] once all of it acts
    Ramp ramp_;
};

}    // namespace stylet::end_load
