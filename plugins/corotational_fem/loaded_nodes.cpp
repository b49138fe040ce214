#include "loaded_nodes.h"

#include <algorithm>
#include <sstream>

namespace stylet::corotational_fem {

namespace {

// Of a patch's place: nodes are where cells and files put them, in decimals that were rounded.
constexpr double rounding = 1e-9;    // [m]

std::vector<int> surface_nodes(std::span<const BoundaryFace> boundary) {
    std::vector<int> nodes;
    for (const BoundaryFace& face : boundary) nodes.insert(nodes.end(), face.nodes.begin(), face.nodes.end());
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    return nodes;
}

bool holds(const Patch& patch, const Vector3& point) {
    return ((point - patch.centre).array().abs() <= 0.5 * patch.size.array() + rounding).all();
}

double nearest(const Patch& patch, const Mesh& mesh, const std::vector<int>& nodes) {
    double nearest = std::numeric_limits<double>::infinity();    // [m]
    for (const int node : nodes) nearest = std::min(nearest, (mesh.nodes[node] - patch.centre).norm());
    return nearest;
}

}    // namespace

void LoadedNodes::place(std::span<const Patch> patches, const Mesh& mesh, std::span<const BoundaryFace> boundary) {
    forces_.clear();
    starts_.assign(1, 0);
    const std::vector<int> nodes = surface_nodes(boundary);
    for (const Patch& patch : patches) {
        for (const int node : nodes) {
            if (holds(patch, mesh.nodes[node])) forces_.push_back({node, Vector3::Zero()});
        }
        if (forces_.size() == starts_.back()) {
            std::ostringstream text;
            text << "found a patch without a node of the mesh's surface, wanted one that holds some: the nearest is "
                 << nearest(patch, mesh, nodes) << " m from its centre";
            throw Error("centre", text.str());
        }
        starts_.push_back(forces_.size());
    }
}

std::span<const NodeForce> LoadedNodes::share(std::span<const Vector3> forces) {
    for (std::size_t patch = 0; patch + 1 < starts_.size(); ++patch) {
        const auto count = static_cast<double>(starts_[patch + 1] - starts_[patch]);
        for (std::size_t i = starts_[patch]; i < starts_[patch + 1]; ++i) forces_[i].force = forces[patch] / count;
    }
    return forces_;
}

}    // namespace stylet::corotational_fem
