#pragma once

#include "mesh/faces.h"
#include "solver.h"

#include <stylet/patch.h>

#include <span>

namespace stylet::corotational_fem {

/// The patches of the surface that effects load, each by the boundary's nodes in it, and the forces on those.
class LoadedNodes {
public:
    /// Throws Error at `centre` where a patch holds no node of the boundary.
    void place(std::span<const Patch> patches, const Mesh& mesh, std::span<const BoundaryFace> boundary);

    /// Shares each patch's force [N] evenly among its nodes.
    std::span<const NodeForce> share(std::span<const Vector3> forces);

    [[nodiscard]] std::span<const NodeForce> nodes_of(int patch) const {
        return std::span(forces_).subspan(starts_[patch], starts_[patch + 1] - starts_[patch]);
    }

private:
    std::vector<NodeForce> forces_;    // of one patch after the other
    std::vector<std::size_t> starts_{0};
};

}    // namespace stylet::corotational_fem
