#pragma once

#include "mesh/gmsh_scanner.h"

#include <stylet/types.h>

#include <array>
#include <map>
#include <vector>

namespace stylet::corotational_fem {

/// A physical group that the file names.
struct GmshGroup {
    int dimension;    // 0 points … 3 volumes
    int tag;          // unique within its dimension
    std::string name;
    std::size_t place;    // in the file
};

/// A point, line, triangle, quadrangle or tetrahedron, with its nodes at its corners alone.
struct GmshElement {
    std::uint64_t tag;
    int dimension;
    int entity;                  // see GmshContent::groups_of
    std::array<int, 4> nodes;    // indices into GmshContent::nodes, as many as it has corners
    int corners;
    std::size_t place;    // in the file
};

/// What a Gmsh file says, whatever its version and form.
struct GmshContent {
    std::vector<std::uint64_t> node_tags;    // each once
    std::vector<Vector3> nodes;              // in the file's unit, finite
    std::vector<GmshElement> elements;
    std::vector<GmshGroup> groups;
    /// The tags of the groups that an entity of the geometry belongs to, by dimension and entity. Version 2.2 gives an element's
    /// group without its entity: there a group is its own entity.
    std::map<std::array<int, 2>, std::vector<int>> groups_of;
};

/// Reads versions 2.2 and 4.1, text and binary. Throws Error at `mesh` where the file is anything else, is damaged, or has
/// elements that GmshElement does not list.
[[nodiscard]] GmshContent read_content(GmshScanner& scanner);

}    // namespace stylet::corotational_fem
