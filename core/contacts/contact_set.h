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
    Vector3 own_force = Vector3::Zero();    // [N] on the needle, whatever the motion

    Vector3 old_force = Vector3::Zero();       // [N] on the needle at the last commit
    Vector3 old_position = Vector3::Zero();    // [m] of the needle's material point at the last commit

    Vector3 force = Vector3::Zero();    // [N] on the needle, all of it (out)
    double axial_force = 0.0;           // [N] the friction or tip force alone (out)
    double old_axial_force = 0.0;       // [N] the same at the last commit, in this frame
    double advance = 0.0;               // [m] of the needle past the tissue, from where the contact stands (out)
    Vector3 carried_over =
        Vector3::Zero();    // [m] in the frame: of the tissue past the needle, only by moving contact points (out)
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
        relocated = false;
    }
    [[nodiscard]] bool empty() const { return points.empty(); }

    std::vector<ContactPoint> points;
    std::vector<ContactRow> rows;
    bool relocated = false;    // a contact stands elsewhere than in the last solve
};

}    // namespace stylet::core
