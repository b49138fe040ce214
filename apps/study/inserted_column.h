#pragma once

#include "core/scene/scene.h"

#include <stylet/buckling_model.h>

namespace stylet::study {

/// How deep the tip of the scene's needle can be [m].
[[nodiscard]] double deepest(const core::Scene& scene);

/// The scene's needle as a column that went in at a right angle, `inserted` [m] of it, at most `deepest`.
[[nodiscard]] Column inserted_column(const core::Scene& scene, double inserted);

}    // namespace stylet::study
