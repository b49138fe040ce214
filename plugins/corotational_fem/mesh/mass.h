#pragma once

#include "mesh/mesh.h"

#include <span>

namespace stylet::corotational_fem {

/// A quarter of each tetrahedron's mass at each of its nodes [kg]. Throws Error at `layers` where a density is missing.
[[nodiscard]] VectorX lumped_mass(const Mesh& mesh, std::span<const Material> materials);

}    // namespace stylet::corotational_fem
