#pragma once

#include "mesh/faces.h"
#include "solver.h"

#include <stylet/patch.h>

#include <span>

namespace stylet::corotational_fem {

/// What of a patch shares its force: the boundary's nodes in it, each as much, or its area, as a traction that is the same for
/// every mesh.
enum class SharedBy : char { nodes, area };

/// The patches of the surface that effects load, each by how much the mesh's nodes take part in it, and the forces on those.
class LoadedNodes {
public:
    explicit LoadedNodes(SharedBy shared_by) : shared_by_(shared_by) {}

    /// Throws Error at `centre` where a patch holds no node, or no area, of the boundary.
    void place(std::span<const Patch> patches, const Mesh& mesh, std::span<const BoundaryFace> boundary);

    /// Shares each patch's force [N] among its nodes.
    std::span<const NodeForce> share(std::span<const Vector3> forces);

    /// Which add up to one: a force on the patch works along the mean displacement that has them.
    [[nodiscard]] std::span<const NodeWeight> weights_of(int patch) const {
        return std::span(weights_).subspan(starts_[patch], starts_[patch + 1] - starts_[patch]);
    }

private:
    SharedBy shared_by_;
    std::vector<NodeWeight> weights_;    // of one patch after the other
    std::vector<NodeForce> forces_;
    std::vector<std::size_t> starts_{0};
};

}    // namespace stylet::corotational_fem
