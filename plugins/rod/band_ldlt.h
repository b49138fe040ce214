#pragma once

#include <stylet/types.h>

#include <array>
#include <vector>

namespace stylet::rod {

/// Many right-hand sides, one a column; a row lies together in memory.
using Columns = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// A symmetric band matrix and its factors L D Lᵀ, without pivoting: O(n) in time and memory. It need not be definite; the
/// negative entries of D count its negative eigenvalues (Sylvester). Allocates when made, never later.
class BandLdlt {
public:
    static constexpr int band = 11;    // entries below the diagonal: the chain's (chain.h)

    explicit BandLdlt(int rows) : columns_(rows) {}

    [[nodiscard]] int rows() const { return static_cast<int>(columns_.size()); }
    void clear();
    void add(int i, int j, double value) {    // j ≤ i ≤ j + band; the lower triangle
        columns_[j][i - j] += value;
    }
    [[nodiscard]] double at(int i, int j) const { return columns_[j][i - j]; }

    /// In place. Returns how many eigenvalues are negative.
    int factor();

    /// b ← A⁻¹ b, after factor().
    void solve(VectorX& b) const;

    /// Of many right-hand sides, the columns of `b`: column c is zero above its row `starts[c]`, starts never fall from column to
    /// column, and the solution is wanted from there on only. Rows above are left as they were.
    void solve(Columns& b, const std::vector<int>& starts, int count) const;

private:
    std::vector<std::array<double, band + 1>> columns_;    // columns_[j][k] = A(j + k, j), then D and L
};

}    // namespace stylet::rod
