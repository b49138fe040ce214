#pragma once

#include "core/export/unstructured_grid.h"
#include "core/run/simulation.h"
#include "core/scene/scene.h"

namespace stylet::core {

/// The tissue's block as a grid of 25 × 25 × 13 points and one more sheet for each border of two layers. Where there is a needle,
/// it is finest around the point of the surface that the needle heads for: one radius across, a hundredth of the block's depth
/// down; from there each cell is longer than the last. Without one all cells are alike.
///
/// Points are where the tissue is now. Of each point: `displacement` [m], so that point − displacement is where it was
/// undeformed. Of each cell: `layer`, from 0 at the top. Of the whole: "layer 0: NAME", whose value is the layer's Young's
/// modulus [Pa], and what the recording says of the tissue.
class TissueGrid {
public:
    /// The grid keeps its material points: made once, as the simulation begins.
    TissueGrid(const Scene& scene, const Simulation& simulation);

    [[nodiscard]] UnstructuredGrid at_present(const Simulation& simulation) const;

private:
    UnstructuredGrid undeformed_;
};

/// `length` [m] cut into `count` pieces, the first of them `first` [m] long and each longer than the last by the same factor; of
/// equal length where that is shorter. Returns how far from 0 each of them ends; nothing where there is no length.
[[nodiscard]] std::vector<double> graded(double length, int count, double first);

}    // namespace stylet::core
