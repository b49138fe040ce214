// Where needle and tissue meet, as the fast solver sees it.
#pragma once

#include "fast/nodal.h"
#include "fast/reach.h"
#include "solver.h"

#include <stylet/workers.h>

#include <span>
#include <vector>

namespace stylet::corotational_fem {

/// The footprints that contacts have on the mesh, and how far each moves for forces on the others by the factor alone: W = J A⁻¹
/// Jᵀ. A footprint's part of W is worked out when it is first asked for, and holds until that contact is placed anew.
class Contacts {
public:
    /// Panels and workers must outlive it.
    Contacts(Panels& panels, Workers& workers);

    void place(int contact, std::span<const NodeWeight> footprint);

    /// W of the first n contacts, [m/N].
    [[nodiscard]] auto compliance(int contacts) {
        answer(contacts);
        return compliance_.topLeftCorner(3 * contacts, 3 * contacts);
    }

    /// Adds Jᵀλ [N] to nodal forces, by place.
    void press(std::span<const double> lambda, NodalVector& forces) const;

    /// Adds a force [N] on a contact that W has been asked of to the solve whose forward half has been done.
    void push(int contact, const Vector3& force) { reaches_[contact].push(force); }

    /// Jx of one contact: the mean of a vector with an entry for each place.
    [[nodiscard]] Vector3 mean(int contact, const NodalVector& x) const;

private:
    struct Placed {
        std::vector<NodeWeight> footprint;
        bool answered = false;
    };

    void answer(int contacts);

    const Dissection& dissection_;
    Workers& workers_;
    std::vector<Placed> placed_;
    std::vector<int> asked_;    // contacts without their part of W
    std::vector<Reach> reaches_;
    MatrixX compliance_;
};

}    // namespace stylet::corotational_fem
