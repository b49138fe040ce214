// The contacts of one solve: where they are, what they may carry, and what came out.
#pragma once

#include <stylet/body.h>
#include <stylet/force_model.h>

#include <vector>

namespace stylet::core {

/// One contact's row of the coupling. Axial quantities are along −axis, so that a positive force resists insertion.
struct ContactRow {
    Matrix3 frame = Matrix3::Identity();    // columns: two lateral directions, −axis; the needle's own, frozen for the solve
    bool lateral = false;                   // held sideways on its track
    double lower = 0.0, upper = 0.0;        // [N] what the axial force may be
    double gap = 0.0;                       // [m] that the needle must still advance before the axial force acts
    Vector3 own_force = Vector3::Zero();    // [N] of the effects on the needle, whatever the motion

    bool first_held = false;             // held sideways for the first time: from where it happens to be, without force
    Vector3 beside = Vector3::Zero();    // [m] how far beside its track it is held (out where first_held)

    // At the last commit.
    Vector3 old_force = Vector3::Zero();           // [N] on the needle, all of it
    Vector3 old_effect_force = Vector3::Zero();    // [N] of that, what the coupling and the effects exert
    Vector3 old_sideways = Vector3::Zero();        // [N] and of all of it, what was across the needle
    double old_configurational = 0.0;              // [N] and the rest, along −axis: see Coupling
    double old_excess = 0.0;                       // [N]
    double old_advance = 0.0;                      // [m]
    Vector3 old_position = Vector3::Zero();        // [m] of the needle's material point

    // Out.
    int held = 0;                                 // +1, −1: the solve kept it from going further forward or back than it may
    double excess = 0.0;                          // [N] of axial_force, what holding it took beyond its law
    Vector3 force = Vector3::Zero();              // [N] on the needle, all of it
    Vector3 effect_force = Vector3::Zero();       // [N]
    Vector3 sideways = Vector3::Zero();           // [N] of all of it, what is across the needle
    double configurational = 0.0;                 // [N]
    double axial_force = 0.0;                     // [N] the friction or tip force alone
    double advance = 0.0;                         // [m] of the needle past the tissue, from where the contact stands
    Vector3 tissue_position = Vector3::Zero();    // [m] of the tissue's point, after the step
    Vector3 offset = Vector3::Zero();             // [m] in the frame: from the tissue's point to the needle's, after the step
    Vector3 carried_over = Vector3::Zero();    // [m] in the frame: of the tissue past the needle, only by moving contact points
};

/// Where the shaft crosses the surface.
struct Mouth {
    int row = -1;         // of the contact there, −1: the needle is outside
    double grip = 0.0;    // from 0 to 1: how firmly the track holds the needle's direction there
};

/// Row 0 is the tip's; the others are shaft contacts in the order in which the tip passed them. Memory for max_contacts is set
/// aside.
struct ContactSet {
    ContactSet() {
        points.reserve(max_contacts);
        rows.reserve(max_contacts);
    }
    void clear() {
        points.clear();
        rows.clear();
    }
    [[nodiscard]] bool empty() const { return points.empty(); }

    std::vector<ContactPoint> points;
    std::vector<ContactRow> rows;
    bool in_air = false;    // the one row is the tip of a needle that is alone: what pushes it comes from outside
};

}    // namespace stylet::core
