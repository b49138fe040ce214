// A simulation's bodies and what acts between them as grids, at the end of its last tick.
#pragma once

#include "core/export/unstructured_grid.h"
#include "core/run/simulation.h"
#include "core/scene/scene.h"

namespace stylet::core {

/// `TimeValue` [s], as VTK calls it, and what the recording says of the needle or the tissue at that time, by the names of its
/// columns.
[[nodiscard]] std::vector<FieldValue> recorded_of(Column::Of body, const Sample& sample);

/// The needle's centre line as a row of lines. Of each point: `arclength` from the base [m], `radius` [m], `inside` (1 in its
/// track). Of the whole: what the recording says of it, and `buckled` (1 where it is).
[[nodiscard]] UnstructuredGrid needle_grid(const Scene& scene, const Simulation& simulation);

/// Where needle and tissue touch, as points; the tip alone, without force, where they don't. Of each: `force` [N] on the needle,
/// `tip` (1 for the tip's).
[[nodiscard]] UnstructuredGrid contact_grid(const Scene& scene, const Simulation& simulation);

}    // namespace stylet::core
