#include "mesh/gmsh_reading.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace stylet::corotational_fem {

std::uint64_t GmshReading::count(const std::string& what, std::size_t values) {
    const auto found = scanner.value<std::uint64_t>("the number of " + what);
    scanner.refuse_beyond_file(found, values, what);
    return found;
}

int GmshReading::group_tag() {
    const int tag = scanner.value<int>("the tag of a physical group");
    if (tag == std::numeric_limits<int>::min())
        throw scanner.complaint("found a tag out of range, wanted that of a physical group");
    return std::abs(tag);
}

Vector3 GmshReading::node_place() {
    Vector3 place;
    for (double& along : place) {
        along = scanner.value<double>("a node's coordinate");
        if (!std::isfinite(along)) throw scanner.complaint("found a coordinate that is not finite, wanted a number");
    }
    return place;
}

void GmshReading::index_nodes() {
    for (std::size_t i = 0; i < content.node_tags.size(); ++i) by_tag_.emplace_back(content.node_tags[i], static_cast<int>(i));
    std::sort(by_tag_.begin(), by_tag_.end());
    const auto same_tag = [](const auto& a, const auto& b) { return a.first == b.first; };
    const auto twice = std::adjacent_find(by_tag_.begin(), by_tag_.end(), same_tag);
    if (twice == by_tag_.end()) return;
    throw scanner.complaint("found two nodes with the tag " + std::to_string(twice->first) + " up to here, wanted each tag once");
}

int GmshReading::node_index(std::uint64_t tag) const {
    const auto found = std::lower_bound(by_tag_.begin(), by_tag_.end(), std::pair{tag, 0});
    if (found == by_tag_.end() || found->first != tag) {
        throw scanner.complaint("found an element with the node " + std::to_string(tag) +
                                ", wanted nodes that $Nodes lists before it");
    }
    return found->second;
}

void GmshReading::add(const GmshElement& element, std::span<const std::uint64_t> tags) {
    GmshElement& added = content.elements.emplace_back(element);
    for (int i = 0; i < element.corners; ++i) added.nodes[i] = node_index(tags[i]);
}

GmshElement GmshReading::element_of(int type) const {
    struct Shape {
        int type, dimension, corners;
    };
    constexpr Shape shapes[] = {{15, 0, 1}, {1, 1, 2}, {2, 2, 3}, {3, 2, 4}, {4, 3, 4}};
    for (const Shape& shape : shapes) {
        if (shape.type != type) continue;
        GmshElement element{};
        element.dimension = shape.dimension;
        element.corners = shape.corners;
        return element;
    }
    const bool other_volume = type >= 5 && type <= 7;
    throw scanner.complaint("found an element of type " + std::to_string(type) +
                            (other_volume
                                 ? " (a hexahedron, prism or pyramid), wanted tetrahedra of four nodes"
                                 : " (of second order or higher, or unknown), wanted tetrahedra of four nodes (gmsh -order 1)"));
}

}    // namespace stylet::corotational_fem
