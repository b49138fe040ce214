#pragma once

#include "mesh/mesh.h"

namespace stylet::corotational_fem {

/// Groups the tetrahedra of any mesh into patches, a value for Mesh::patches: of one layer each, connected through faces, most of
/// them 6 to 14 tetrahedra around a node. Six tetrahedra a node is what a mesh has, so that a pressure a patch leaves about three
/// displacements for each, as the continuum has. What is left over joins the smallest neighbouring patch of its layer; where
/// there is none it is a patch of its own, however small.
///
/// Greedy, from the lowest node up. Order is by the nodes' places, so that the patches don't depend on how a file numbers its
/// nodes and tetrahedra. Patches are numbered from 0.
[[nodiscard]] std::vector<int> patches_of(const Mesh& mesh);

}    // namespace stylet::corotational_fem
