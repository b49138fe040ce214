#pragma once

#include "mesh/mesh.h"

#include <stylet/setup.h>

#include <string>

namespace stylet::corotational_fem {

/// The nodes of a physical group that a file names.
struct NodeSet {
    std::string name;
    int dimension;             // of the group: 0 points … 3 volumes
    std::vector<int> nodes;    // ascending
};

/// A mesh from a file. Nodes are in the file's order, tetrahedra too.
struct GmshMesh {
    Mesh mesh;
    MeshTags tags;
    std::vector<NodeSet> node_sets;
};

/// Reads the linear tetrahedra of a Gmsh file (.msh) of version 2.2 or 4.1, text or binary; points, lines and surfaces only make
/// node sets. `unit` [m] is the length of the file's unit: the format has none.
///
/// Layers: each tetrahedron is in one named physical volume, whose name is that of a layer of the tissue; every layer has some. A
/// file that names no volume will do for a tissue of one layer.
/// Place: the mesh is where the file has it; what it spans must be the tissue's block (top at z = 0) to 1e-6 of its size.
/// Held are the nodes of the named set `fixed`; where that is empty, those on the planes of the mesh's own bounding box that
/// TissueSetup::fixed tells of, to 1e-9 of its size.
///
/// Throws Error at `mesh`: `file:line: found …, wanted …` (of a binary file its byte), or with all that check_mesh finds. A
/// damaged file costs no more memory and time than a sound one of its size. Source: Gmsh reference manual 4.8, "MSH file format".
/// Left out: partitioned meshes, elements of other types.
[[nodiscard]] GmshMesh read_gmsh_file(const std::string& path, double unit, const TissueSetup& tissue, const std::string& fixed);

}    // namespace stylet::corotational_fem
