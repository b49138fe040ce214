#pragma once

#include "core/scene/scene.h"

#include <stylet/buckling_model.h>

#include <string>

namespace stylet::app {

/// The scene's needle as a column, its tip at a depth [m] that it reached at a right angle. Throws core::SceneErrors, which
/// quotes what the user `gave`, where it cannot be there.
[[nodiscard]] Column column_at_depth(const core::Scene& scene, double depth, const std::string& gave);

/// The spring constant [Pa] of Eq. (3), in the form that the paper's tables were calculated with, for which the column has this
/// critical load [N]. Throws core::SceneErrors where Eq. (3) doesn't know such a column.
[[nodiscard]] double equivalent_stiffness(const core::Scene& scene, const Column& column, double load);

}    // namespace stylet::app
