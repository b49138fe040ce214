#include "load/loaded_nodes.h"

#include "load/patch_weights.h"

#include <algorithm>
#include <limits>
#include <sstream>

namespace stylet::corotational_fem {

namespace {

double nearest(const Patch& patch, const Mesh& mesh, std::span<const BoundaryFace> boundary) {
    double nearest = std::numeric_limits<double>::infinity();    // [m]
    for (const BoundaryFace& face : boundary) {
        for (const int node : face.nodes) nearest = std::min(nearest, (mesh.nodes[node] - patch.centre).norm());
    }
    return nearest;
}

}    // namespace

void LoadedNodes::place(std::span<const Patch> patches, const Mesh& mesh, std::span<const BoundaryFace> boundary) {
    const bool by_area = shared_by_ == SharedBy::area;
    weights_.clear();
    starts_.assign(1, 0);
    for (const Patch& patch : patches) {
        const std::vector<NodeWeight> weights =
            by_area ? weights_by_area(patch, mesh, boundary) : weights_by_nodes(patch, mesh, boundary);
        if (weights.empty()) {
            std::ostringstream text;
            text << "found a patch without " << (by_area ? "area on" : "a node of")
                 << " the mesh's surface, wanted one that holds some: the nearest " << (by_area ? "node " : "") << "is "
                 << nearest(patch, mesh, boundary) << " m from its centre";
            throw Error("centre", text.str());
        }
        weights_.insert(weights_.end(), weights.begin(), weights.end());
        starts_.push_back(weights_.size());
    }
    forces_.clear();
    for (const NodeWeight& each : weights_) forces_.push_back({each.node, Vector3::Zero()});
}

std::span<const NodeForce> LoadedNodes::share(std::span<const Vector3> forces) {
    for (std::size_t patch = 0; patch + 1 < starts_.size(); ++patch) {
        for (std::size_t i = starts_[patch]; i < starts_[patch + 1]; ++i) forces_[i].force = weights_[i].weight * forces[patch];
    }
    return forces_;
}

}    // namespace stylet::corotational_fem
