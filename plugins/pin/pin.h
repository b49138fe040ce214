#pragma once

#include <stylet/force_model.h>

namespace stylet::pin {

/// Holds the tip of a needle that is alone, in air, where it is at time 0: a hand that pushes the base compresses the needle
/// against a rigid stop.
///
///     u_tip = 0
///
/// Sideways core holds the tip by itself, as the needle's `ends` say; this adds that it cannot move along the needle. Source: the
/// supports of Euler's columns, Timoshenko and Gere 1961, section 2.1. Valid for ends that are held: a needle whose ends are
/// clamped-free is refused, and so is a scene with a tissue or without a needle (Error). Leaves out any give of the stop.
class Pin final : public ForceModel {
public:
    explicit Pin(const Setup& setup);

    void add_to(const Contact& contact, ContactLaw& law) const override;
};

}    // namespace stylet::pin
