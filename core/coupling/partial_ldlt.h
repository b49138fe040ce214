#pragma once

#include <stylet/types.h>

#include <vector>

namespace stylet::core {

/// Eliminates the first m rows of a symmetric matrix that need not be definite.
///
///     P [A11 A12] Pᵀ = [L11  0] [D  0] [L11ᵀ L21ᵀ]        S = A22 − A21 A11⁻¹ A12
///       [A21 A22]      [L21  1] [0  S] [0    1   ]
///
/// D has pivots of size 1 and 2, chosen among the first m rows only (Bunch and Kaufman 1977, partial pivoting), so that the
/// negative eigenvalues of A11 can be counted from it (Sylvester). Allocates when made, never later. Only the lower triangle is
/// read or written.
class PartialLdlt {
public:
    explicit PartialLdlt(int max_rows);

    struct Inertia {
        int negatives = 0;
        bool singular = false;    // a pivot was zero: the rows do not determine their forces
    };

    /// In place: `a` (n × n) comes back with S in its last n − m rows and columns. It must stay untouched until the solves are
    /// done.
    Inertia eliminate(Eigen::Ref<MatrixX> a, int m);

    /// b ← [L11⁻¹ P b1; b2 − A21 A11⁻¹ b1].
    void reduce(const Eigen::Ref<const MatrixX>& a, Eigen::Ref<VectorX> b) const;

    /// From a reduced b and the unknowns x2 (already in x): x1 = −A11⁻¹ (b1 + A12 x2), into x.
    void substitute(const Eigen::Ref<const MatrixX>& a, const Eigen::Ref<const VectorX>& b, Eigen::Ref<VectorX> x) const;

private:
    void swap_rows(Eigen::Ref<MatrixX> a, int i, int j) const;
    int choose_pivot(Eigen::Ref<MatrixX> a, int k);
    void eliminate_one(Eigen::Ref<MatrixX> a, int k);
    void eliminate_two(Eigen::Ref<MatrixX> a, int k);

    int eliminated_ = 0;
    std::vector<int> swaps_;    // row k was swapped with swaps_[k]
    std::vector<int> sizes_;    // 1 or 2 at the first row of a pivot, 0 at the second row of a pair
    VectorX diagonal_;          // D
    VectorX off_diagonal_;      // D's entry below the diagonal of a pair, at its first row
    VectorX first_, second_;    // the pivot's columns before they become L
};

}    // namespace stylet::core
