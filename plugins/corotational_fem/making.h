// From a scene to a mesh, its materials, its motion and what solves them.
#pragma once

#include "solver.h"

#include <stylet/setup.h>

#include <memory>

namespace stylet::corotational_fem {

/// The block or the file that the scene names, checked. Throws Error.
[[nodiscard]] Mesh mesh_of(const Setup& setup);

[[nodiscard]] std::vector<Material> materials_of(const TissueSetup& tissue);

/// `mesh` and `materials` must outlive it. Throws Error where the mesh can't be solved.
[[nodiscard]] std::unique_ptr<Solver> solver_of(const Setup& setup, const Mesh& mesh, std::span<const Material> materials);

}    // namespace stylet::corotational_fem
