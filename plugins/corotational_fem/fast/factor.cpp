#include "fast/factor.h"

#include <stylet/error.h>

#include <Eigen/Cholesky>

#include <algorithm>

namespace stylet::corotational_fem {

namespace {

// A pivot that has shrunk to this part of what it was is rounding alone: eliminating some 10⁴ unknowns leaves errors of about 100
// units in the last place (2·10⁻¹⁶), while the softest motion of a tissue whose layers differ by 10⁶ leaves 10⁻¹⁰.
constexpr double rounding = 1e-13;

}    // namespace

Factor::Factor(const Dissection& dissection)
    : dissection_(dissection),
      children_(dissection.supernodes.size()),
      blocks_(dissection.supernodes.size()),
      updates_(dissection.supernodes.size()) {
    for (int s = 0; s < static_cast<int>(children_.size()); ++s) {
        if (const int parent = dissection.parent(s); parent >= 0) children_[parent].push_back(s);
    }
}

void Factor::refactor(const BlockMatrix& matrix, Workers& workers) {
    std::vector<int> singular(dissection_.groups.size(), -1);
    for (int stage = 0; stage < dissection_.stages; ++stage) {
        const auto in_stage = [&](const Group& group) { return group.stage == stage; };
        const auto begin = std::find_if(dissection_.groups.begin(), dissection_.groups.end(), in_stage);
        const int first = static_cast<int>(begin - dissection_.groups.begin());
        const int count = static_cast<int>(std::count_if(begin, dissection_.groups.end(), in_stage));
        workers.each(count, [&](int task) {
            const Group& group = dissection_.groups[first + task];
            std::vector<int> position(dissection_.places());
            for (int s = group.begin; s < group.end && singular[first + task] < 0; ++s) {
                if (!eliminate(s, matrix, position)) singular[first + task] = s;
            }
        });
        for (const int s : singular) {
            if (s < 0) continue;
            for (MatrixX& update : updates_) update.resize(0, 0);
            const int node = matrix.mesh_node[dissection_.row[dissection_.supernodes[s].first]];
            throw Error(
                "singular: about node " + std::to_string(node) +
                " found a part of the tissue that nothing holds, or a material that no pressure keeps in shape; wanted fixed "
                "nodes that keep each connected part from moving and from turning, and materials with μ > 0 and λ > −2μ/3");
        }
    }
}

// False where the supernode's own block is not positive definite. `position` is room for a number for each place.
bool Factor::eliminate(int s, const BlockMatrix& matrix, std::vector<int>& position) {
    const Supernode& supernode = dissection_.supernodes[s];
    const int own = 3 * supernode.size, below = 3 * supernode.rows;
    const int* rows = dissection_.rows.data() + supernode.rows_begin;
    for (int i = 0; i < supernode.size; ++i) position[supernode.first + i] = 3 * i;
    for (int i = 0; i < supernode.rows; ++i) position[rows[i]] = own + 3 * i;

    // The lower triangle of what is known of these rows: from the matrix, and from the supernodes eliminated before.
    MatrixX front = MatrixX::Zero(own + below, own);
    MatrixX update = MatrixX::Zero(below, below);
    for (int i = 0; i < supernode.size; ++i) {
        const int row = dissection_.row[supernode.first + i];
        for (int at = matrix.start[row]; at < matrix.start[row + 1]; ++at) {
            const int place = dissection_.place[matrix.column[at]];
            if (place >= supernode.first) front.block<3, 3>(position[place], 3 * i) = matrix.block[at].transpose();
        }
    }
    VectorX before = front.diagonal();
    for (const int child : children_[s]) {
        const Supernode& from = dissection_.supernodes[child];
        const int* from_rows = dissection_.rows.data() + from.rows_begin;
        const MatrixX& values = updates_[child];
        for (int j = 0; j < from.rows; ++j) {
            const int column = position[from_rows[j]];
            for (int i = j; i < from.rows; ++i) {
                const int row = position[from_rows[i]];
                if (column < own) {
                    front.block<3, 3>(row, column) += values.block<3, 3>(3 * i, 3 * j);
                } else {
                    update.block<3, 3>(row - own, column - own) += values.block<3, 3>(3 * i, 3 * j);
                }
            }
        }
        updates_[child].resize(0, 0);
    }

    const Eigen::LLT<MatrixX> cholesky(front.topRows(own));
    if (cholesky.info() != Eigen::Success) return false;
    const VectorX pivots = cholesky.matrixLLT().diagonal().cwiseAbs2();
    if (!(pivots.array() > rounding * before.array()).all()) return false;

    Blocks& blocks = blocks_[s];
    blocks.inverse = cholesky.solve(MatrixX::Identity(own, own));
    blocks.below.noalias() = front.bottomRows(below) * blocks.inverse;
    update.triangularView<Eigen::Lower>() -= blocks.below * front.bottomRows(below).transpose();
    updates_[s] = std::move(update);
    return true;
}

void Factor::solve(Eigen::Ref<VectorX> x) const {
    const int count = static_cast<int>(blocks_.size());
    VectorX rows;
    for (int s = 0; s < count; ++s) {
        const Supernode& supernode = dissection_.supernodes[s];
        rows = blocks_[s].below * x.segment(3 * supernode.first, 3 * supernode.size);
        for (int i = 0; i < supernode.rows; ++i) {
            x.segment<3>(3 * dissection_.rows[supernode.rows_begin + i]) -= rows.segment<3>(3 * i);
        }
    }
    for (int s = count - 1; s >= 0; --s) {
        const Supernode& supernode = dissection_.supernodes[s];
        rows.resize(3 * supernode.rows);
        for (int i = 0; i < supernode.rows; ++i) {
            rows.segment<3>(3 * i) = x.segment<3>(3 * dissection_.rows[supernode.rows_begin + i]);
        }
        auto own = x.segment(3 * supernode.first, 3 * supernode.size);
        own = (blocks_[s].inverse * own - blocks_[s].below.transpose() * rows).eval();
    }
}

}    // namespace stylet::corotational_fem
