// The dense matrix of one supernode and its rows while it is being eliminated.
#pragma once

#include "fast/kernels.h"

#include <stylet/types.h>
#include <stylet/workers.h>

#include <span>
#include <vector>

namespace stylet::corotational_fem {

/// A symmetric matrix [F₁₁ F₂₁ᵀ; F₂₁ F₂₂] of which the first `own` unknowns are swept out (Goodnight 1979, in blocks):
///     F₁₁ → −F₁₁⁻¹,    F₂₁ → F₂₁ F₁₁⁻¹,    F₂₂ → F₂₂ − F₂₁ F₁₁⁻¹ F₂₁ᵀ.
class Front {
public:
    /// All zero.
    Front(int own, int below, const DenseKernel& kernel);

    /// Of the lower triangle, the only one that counts: row ≥ column.
    [[nodiscard]] double& operator()(int row, int column) { return values_(row, column); }
    [[nodiscard]] double operator()(int row, int column) const { return values_(row, column); }

    /// False, with the front spoilt, where a pivot is not greater than this: F₁₁ is not positive definite. One number for each
    /// own unknown.
    [[nodiscard]] bool sweep(std::span<const double> least, Workers& workers);

private:
    using Block = Eigen::Ref<const MatrixX>;

    [[nodiscard]] bool sweep_block(int first, int last, std::span<const double> least, Workers& workers);
    void take(int first, int last);
    void multiply(const Block& inverse, Workers& workers);
    void subtract(int depth, Workers& workers);
    void put_back(int first, int last, const Block& inverse);
    [[nodiscard]] int tasks() const;

    const DenseKernel& kernel_;
    int own_;
    MatrixX values_;                                // padded with zeros
    MatrixX columns_;                               // W of a block: its columns, without its own rows
    MatrixX swept_;                                 // V = W times the inverse of the block's own part
    std::vector<double> left_, right_, inverse_;    // packed for the kernel
};

}    // namespace stylet::corotational_fem
