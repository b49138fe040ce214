// How a force on a patch of a mesh's surface acts on its nodes.
#pragma once

#include "mesh/faces.h"
#include "solver.h"

#include <stylet/patch.h>

#include <span>
#include <vector>

namespace stylet::corotational_fem {

/// By the nodes of the boundary in the patch's box, each as much. Empty where it holds none.
[[nodiscard]] std::vector<NodeWeight> weights_by_nodes(const Patch& patch, const Mesh& mesh,
                                                       std::span<const BoundaryFace> boundary);

/// By the area of the boundary in the patch's box, as a uniform traction:
///
///     w_a = (1/A) ∫ φ_a dA,    Σ w_a = 1,    Σ w_a x_a = the centroid of the area A
///
/// φ_a is node a's hat function, linear on each face. Faces are cut off at the box and the integral is exact, so that traction,
/// force and moment are the same for every mesh of the same surface. Σ w_a u_a is the mean displacement of the area, along which
/// the force works. A side of the box of no length takes the faces that lie in its plane. Empty where the box holds no area.
///
/// Source: consistent nodal loads, Zienkiewicz and Taylor, The Finite Element Method; Sutherland and Hodgman 1974 for the cuts.
[[nodiscard]] std::vector<NodeWeight> weights_by_area(const Patch& patch, const Mesh& mesh,
                                                      std::span<const BoundaryFace> boundary);

}    // namespace stylet::corotational_fem
