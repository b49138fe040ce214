// One effect: of the needle on the tissue, of the tissue on the needle, or a load that a scene prescribes to one of them. Effects
// only add, so their order never matters.
#pragma once

#include <stylet/patch.h>
#include <stylet/plugin.h>
#include <stylet/types.h>

namespace stylet {

/// One contact as the last commit left it. A needle alone, without a tissue, has one at its tip, in the air.
struct Contact {
    bool tip;                // the tip, or else a piece of shaft
    bool inside;             // the tip has punctured (always true of the shaft)
    int layer;               // index from the top of the layer it is in; −1 in the air
    double coverage;         // [m] shaft length that touches tissue in this contact; zero for the tip
    double axial_force;      // [N] resists insertion when positive
    double slip;             // [m] advance of the needle past the tissue in the last step
    bool slipping;           // the last step slipped
    double needle_radius;    // [m]
    Vector3 axis;            // unit, along the needle toward the tip
    double time;             // [s] at the end of the step that the law is wanted for
};

/// What a contact can carry, summed over the effects.
struct ContactLaw {
    double axial_limit = 0.0;               // [N] shaft: sticks below, slips at
    double tip_limit = 0.0;                 // [N] tip: ruptures or cuts at
    bool tip_limited = false;               // a tip that no effect limits never ruptures
    bool held = false;                      // a tip in the air that something rigid keeps from moving along the needle
    Vector3 own_force = Vector3::Zero();    // [N] on the needle, whatever the motion (a bevel's side force)

    void add_axial(double limit) { axial_limit += limit; }
    void add_tip(double limit) {
        tip_limit += limit;
        tip_limited = true;
    }
};

/// What a step did at the tip, from the solved forces.
struct Settlement {
    bool punctured = false;        // the tip reached its limit outside and went in
    double cut = 0.0;              // [m] new track
    int layer = -1;                // that it was cut in
    double needle_radius = 0.0;    // [m]
};

/// For the constructor of an effect that acts where a needle meets a tissue. Throws Error where the scene lacks one of them.
inline void expect_needle_and_tissue(const Setup& setup) {
    if (setup.needle == nullptr)
        throw Error("found a scene without a needle, wanted one: this acts where a needle meets a tissue");
    if (setup.tissue == nullptr)
        throw Error("found a scene without a tissue, wanted one: this acts where a needle meets a tissue");
}

class ForceModel : public Object {
public:
    static constexpr Role role = Role::effect;

    virtual void add_to(const Contact&, ContactLaw&) const {}

    /// Takes note of a change of state; returns the energy that the change consumed [J].
    virtual double settle(const Settlement&) { return 0.0; }

    /// The patch of the tissue's surface that this effect loads, whatever the contacts do; lives as long as the effect. nullptr
    /// for most.
    [[nodiscard]] virtual const Patch* patch() const { return nullptr; }

    /// [N] on that patch at `time` [s]. Before time 0 nothing acted.
    [[nodiscard]] virtual Vector3 patch_force(double) const { return Vector3::Zero(); }
};

}    // namespace stylet
