#pragma once

#include "mesh/mesh.h"

#include <stylet/setup.h>

namespace stylet::corotational_fem {

/// The tissue's block in nx × ny × nz cells of six tetrahedra each, all cells alike:
///
///     for each order (i, j, k) of the axes, the corners c, c + e_i, c + e_i + e_j, c + e_i + e_j + e_k
///
/// so that each tetrahedron runs along the diagonal of its cell from the least to the greatest corner (Kuhn 1960). Nodes are
/// numbered along x, then y, then z, from the least corner of the block; tetrahedra by cells in the same order. Borders of layers
/// are planes of nodes: each cell added goes to the layer whose cells are thickest, at least one to each, all cells of a layer as
/// thick as each other. The six tetrahedra of a cell are a patch. Throws Error at `cells` where a count is not positive, where nz
/// is less than the number of layers, and where there are more than a million cells.
[[nodiscard]] Mesh block_mesh(const TissueSetup& tissue, const std::array<int, 3>& cells);

}    // namespace stylet::corotational_fem
