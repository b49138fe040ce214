// From what each tetrahedron does at its corners to what all do at a node.
#pragma once

#include "fast/lanes.h"

#include <stylet/workers.h>

#include <span>
#include <vector>

namespace stylet::corotational_fem {

/// Sums corner forces at nodes: each node reads its own corners, in a fixed order, so that no two threads write the same place
/// and the sum is the same bits for any number of them.
class Gather {
public:
    /// `places` says of each corner at which of `nodes` nodes it is; `nodes` itself or more: at none.
    Gather(std::span<const int> places, int nodes);

    /// sums[i] = Σ of corners at node i, for every node.
    void sum(const Float4* corners, Float4* sums, Workers& workers) const;

private:
    std::vector<int> starts_;     // of each node, and the end, in corners_
    std::vector<int> corners_;    // of one node after another
    std::vector<int> shares_;     // the first node of each task, and the end
};

}    // namespace stylet::corotational_fem
