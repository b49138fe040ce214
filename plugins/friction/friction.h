#pragma once

#include <stylet/force_model.h>

#include <optional>

namespace stylet::friction {

/// Dry friction along the shaft, proportional to the length that tissue covers.
///
///     |f| ≤ f_s·c while the contact sticks,   |f| = f_k·c while it slips        (c [m] its covered length, f_s ≥ f_k [N/m])
///
/// Source: Okamura, Simone and O'Leary 2004, the static and dynamic Coulomb terms of their modified Karnopp model. Deviation: no
/// viscous part, and whether a contact sticks is decided by the coupling's forces, not by a band of velocities. Valid where the
/// tissue's grip on the shaft does not depend on depth or speed. Leaves out the tip, the gradual build-up before slip (Dahl) and
/// any change of grip with the pressure of the tissue. Does no positive work: it only bounds a force that core always turns
/// against the slip.
class Friction final : public ForceModel {
public:
    explicit Friction(const Setup& setup);

    void add_to(const Contact& contact, ContactLaw& law) const override;

private:
    double kinetic_;              // [N/m]
    double static_;               // [N/m]
    std::optional<int> layer_;    // every layer where absent
};

}    // namespace stylet::friction
