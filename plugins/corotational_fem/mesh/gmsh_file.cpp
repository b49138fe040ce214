#include "mesh/gmsh_file.h"

#include "mesh/buckets.h"
#include "mesh/complaints.h"
#include "mesh/gmsh_content.h"
#include "mesh/held.h"
#include "mesh/mesh_checks.h"
#include "mesh/patches.h"
#include "mesh/regions.h"

#include <algorithm>
#include <cmath>

namespace stylet::corotational_fem {
namespace {

std::vector<NodeSet> node_sets_of(const GmshContent& content) {
    std::map<std::array<int, 2>, std::vector<int>> nodes;    // by dimension and tag of the group
    for (const GmshElement& element : content.elements) {
        const auto groups = content.groups_of.find({element.dimension, element.entity});
        if (groups == content.groups_of.end()) continue;
        for (const int group : groups->second) {
            auto& of_group = nodes[{element.dimension, group}];
            of_group.insert(of_group.end(), element.nodes.begin(), element.nodes.begin() + element.corners);
        }
    }
    std::vector<NodeSet> sets;
    for (const GmshGroup& group : content.groups) {
        NodeSet& set = sets.emplace_back(NodeSet{group.name, group.dimension, nodes[{group.dimension, group.tag}]});
        std::sort(set.nodes.begin(), set.nodes.end());
        set.nodes.erase(std::unique(set.nodes.begin(), set.nodes.end()), set.nodes.end());
    }
    return sets;
}

Box box_of(const Mesh& mesh) {
    Box box;
    for (const Tetrahedron& nodes : mesh.tetrahedra) {
        for (const int node : nodes) box.take_in(mesh.nodes[node]);
    }
    return box;
}

std::string shown(const Box& box) {
    std::string text;
    for (int axis = 0; axis < 3; ++axis) {
        text +=
            (axis == 0 ? "" : ", ") + figure(box.least[axis]) + " to " + figure(box.greatest[axis]) + " m along " + "xyz"[axis];
    }
    return text;
}

void refuse_unless_block(const Box& box, const TissueSetup& tissue, double unit, const GmshScanner& scanner) {
    constexpr double alike = 1e-6;    // of the size: a file with seven digits still fits
    const Vector3 half = 0.5 * tissue.extent;
    const Box block{Vector3(-half.x(), -half.y(), -tissue.extent.z()), Vector3(half.x(), half.y(), 0.0)};
    const double off =
        std::max((box.least - block.least).cwiseAbs().maxCoeff(), (box.greatest - block.greatest).cwiseAbs().maxCoeff());
    if (off <= alike * tissue.extent.norm()) return;
    throw scanner.complaint_of_file("found a mesh of " + shown(box) + " (a length of 1 in the file is " + figure(unit) +
                                    " m), wanted the tissue's extent: " + shown(block));
}

std::vector<char> nodes_on_planes(const Mesh& mesh, const Box& box, const TissueSetup& tissue) {
    constexpr double rounding = 1e-9;    // of the size
    const double on_plane = rounding * box.size().norm();
    std::vector<char> fixed;
    for (const Vector3& node : mesh.nodes) {
        const bool at_bottom = node.z() - box.least.z() <= on_plane;
        const Vector3 inside = (node - box.least).cwiseMin(box.greatest - node);
        const bool at_side = std::min(inside.x(), inside.y()) <= on_plane;
        fixed.push_back((holds_bottom(tissue) && at_bottom) || (holds_sides(tissue) && at_side));
    }
    return fixed;
}

std::vector<char> nodes_of_set(const GmshMesh& read, const std::string& wanted, const GmshScanner& scanner) {
    const NodeSet* found = nullptr;
    std::string names;
    for (const NodeSet& set : read.node_sets) {
        names += (names.empty() ? "" : ", ") + in_quotes(set.name);
        if (set.name != wanted) continue;
        if (found != nullptr)
            throw scanner.complaint_of_file("found two physical groups " + in_quotes(wanted) + ", wanted one to hold");
        found = &set;
    }
    if (found == nullptr) {
        throw scanner.complaint_of_file("found no physical group " + in_quotes(wanted) +
                                        " to hold, wanted one of the file's: " + (names.empty() ? "it names none" : names));
    }
    std::vector<char> fixed(read.mesh.nodes.size(), 0);
    for (const int node : found->nodes) fixed[node] = 1;
    return fixed;
}

}    // namespace

GmshMesh read_gmsh_file(const std::string& path, double unit, const TissueSetup& tissue, const std::string& fixed) {
    GmshScanner scanner(path);
    const GmshContent content = read_content(scanner);
    GmshMesh read{.mesh = {}, .tags = {.nodes = content.node_tags, .tetrahedra = {}}, .node_sets = node_sets_of(content)};
    for (const Vector3& node : content.nodes) read.mesh.nodes.push_back(unit * node);
    for (const GmshElement& element : content.elements) {
        if (element.dimension != 3) continue;
        read.mesh.tetrahedra.push_back(element.nodes);
        read.tags.tetrahedra.push_back(element.tag);
    }
    if (read.mesh.tetrahedra.empty())
        throw scanner.complaint_of_file("found no tetrahedron of four nodes, wanted a mesh of them");
    read.mesh.layers = layers_of_regions(content, tissue, scanner);
    const Box box = box_of(read.mesh);
    refuse_unless_block(box, tissue, unit, scanner);
    read.mesh.fixed = fixed.empty() ? nodes_on_planes(read.mesh, box, tissue) : nodes_of_set(read, fixed, scanner);
    try {
        check_mesh(read.mesh, read.tags, "mesh");
    } catch (const Error& error) {
        throw scanner.complaint_of_file(error.what());
    }
    read.mesh.patches = patches_of(read.mesh);
    return read;
}

}    // namespace stylet::corotational_fem
