// The inverse of a matrix as dense blocks, one pair a supernode, in double precision.
#pragma once

#include "fast/dissection.h"
#include "fast/front.h"
#include "fast/kernels.h"

#include <stylet/workers.h>

#include <vector>

namespace stylet::corotational_fem {

/// A⁻¹ of a positive definite A, as a block elimination S⁻¹ and M = B S⁻¹ for each supernode: S its own block of A once all
/// earlier supernodes are eliminated (its Schur complement), B what ties its rows to it. With them
///     forward:  r_rows −= M r_own,    backward:  x_own = S⁻¹ r_own − Mᵀ x_rows
/// is a solve. Vectors are in places (Dissection), x, y, z of each.
class Factor {
public:
    /// Holds on to the dissection. Throws stylet::Error where the blocks would take more than half of the machine's memory.
    explicit Factor(const Dissection& dissection, InstructionSet set = best_instruction_set());

    /// Takes these values. Throws stylet::Error "singular: …" where the matrix is not positive definite, to the accuracy of
    /// double precision; the factor is then of no use until the next call that doesn't throw. Allocates.
    void refactor(const BlockMatrix& matrix, Workers& workers);

    /// x := A⁻¹ x; 3 numbers a place.
    void solve(Eigen::Ref<VectorX> x) const;

    /// [m/N] S⁻¹, symmetric.
    [[nodiscard]] Eigen::Map<const MatrixX> inverse(int s) const { return {values_.data() + at_[s], own(s), own(s)}; }

    /// M.
    [[nodiscard]] Eigen::Map<const MatrixX> below(int s) const {
        return {values_.data() + at_[s] + own(s) * own(s), 3 * dissection_.supernodes[s].rows, own(s)};
    }

    [[nodiscard]] const Dissection& dissection() const { return dissection_; }

private:
    [[nodiscard]] int own(int s) const { return 3 * dissection_.supernodes[s].size; }
    [[nodiscard]] bool eliminate(int supernode, const BlockMatrix& matrix, Workers& workers);
    [[nodiscard]] int position(const Supernode& supernode, int place) const;
    void add_matrix(const Supernode& supernode, const BlockMatrix& matrix, Front& front) const;
    void add_update(const Supernode& supernode, int child, Front& front);
    [[noreturn]] void refuse(int node);

    const Dissection& dissection_;
    const DenseKernel& kernel_;
    std::vector<std::vector<int>> children_;    // of each supernode
    std::vector<std::size_t> at_;               // of each supernode, where its blocks are in values_: S⁻¹, then M
    std::vector<double> values_;                // in one piece, which goes back to the operating system when it is freed
    // [N/m] Of each supernode, until its parent has it: what is to be added at its rows, the lower triangle column by column.
    std::vector<std::vector<double>> updates_;
};

}    // namespace stylet::corotational_fem
