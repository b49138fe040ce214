#include "core/coupling/partial_ldlt.h"

#include <cmath>
#include <utility>

namespace stylet::core {

namespace {

// (1 + √17)/8: balances the growth of one step of size 2 against two of size 1 (Bunch and Kaufman 1977).
constexpr double pivot_threshold = 0.6403882032022076;

}    // namespace

PartialLdlt::PartialLdlt(int max_rows)
    : swaps_(max_rows), sizes_(max_rows), diagonal_(max_rows), off_diagonal_(max_rows), first_(max_rows), second_(max_rows) {}

void PartialLdlt::swap_rows(Eigen::Ref<MatrixX> a, int i, int j) const {
    if (i == j) return;    // i < j; only the lower triangle exists
    const auto n = static_cast<int>(a.rows());
    a.row(i).head(i).swap(a.row(j).head(i));
    for (int k = i + 1; k < j; ++k) std::swap(a(k, i), a(j, k));
    a.col(i).segment(j + 1, n - j - 1).swap(a.col(j).segment(j + 1, n - j - 1));
    std::swap(a(i, i), a(j, j));
}

int PartialLdlt::choose_pivot(Eigen::Ref<MatrixX> a, int k) {
    const int left = eliminated_ - k;
    swaps_[k] = k;
    if (left == 1) return 1;
    Eigen::Index where = 0;
    const double largest = a.col(k).segment(k + 1, left - 1).cwiseAbs().maxCoeff(&where);
    if (std::abs(a(k, k)) >= pivot_threshold * largest) return 1;
    const int r = k + 1 + static_cast<int>(where);
    double largest_r = a.row(r).segment(k, r - k).cwiseAbs().maxCoeff();
    if (r + 1 < eliminated_) largest_r = std::max(largest_r, a.col(r).segment(r + 1, eliminated_ - r - 1).cwiseAbs().maxCoeff());
    if (std::abs(a(k, k)) * largest_r >= pivot_threshold * largest * largest) return 1;
    if (std::abs(a(r, r)) >= pivot_threshold * largest_r) {
        swaps_[k] = r;
        swap_rows(a, k, r);
        return 1;
    }
    swaps_[k + 1] = r;    // its own choose_pivot is skipped
    swap_rows(a, k + 1, r);
    return 2;
}

void PartialLdlt::eliminate_one(Eigen::Ref<MatrixX> a, int k) {
    const auto n = static_cast<int>(a.rows());
    const double inverse = 1.0 / diagonal_[k];
    const int below = n - k - 1;
    auto column = first_.head(below);
    column = a.col(k).tail(below);
    a.col(k).tail(below) *= inverse;
    for (int j = 0; j < below; ++j) {
        if (column[j] == 0.0) continue;    // straight tracks don't couple axial with lateral
        a.col(k + 1 + j).tail(below - j) -= column[j] * a.col(k).tail(below - j);
    }
}

void PartialLdlt::eliminate_two(Eigen::Ref<MatrixX> a, int k) {
    const auto n = static_cast<int>(a.rows());
    const int below = n - k - 2;
    const double determinant = diagonal_[k] * diagonal_[k + 1] - off_diagonal_[k] * off_diagonal_[k];
    auto first = first_.head(below), second = second_.head(below);
    first = a.col(k).tail(below);
    second = a.col(k + 1).tail(below);
    a.col(k).tail(below) = (diagonal_[k + 1] * first - off_diagonal_[k] * second) / determinant;
    a.col(k + 1).tail(below) = (diagonal_[k] * second - off_diagonal_[k] * first) / determinant;
    for (int j = 0; j < below; ++j) {
        a.col(k + 2 + j).tail(below - j) -= first[j] * a.col(k).tail(below - j) + second[j] * a.col(k + 1).tail(below - j);
    }
}

PartialLdlt::Inertia PartialLdlt::eliminate(Eigen::Ref<MatrixX> a, int m) {
    eliminated_ = m;
    Inertia inertia;
    for (int k = 0; k < m;) {
        const int size = choose_pivot(a, k);
        sizes_[k] = size;
        diagonal_[k] = a(k, k);
        if (size == 1) {
            inertia.negatives += diagonal_[k] < 0.0;
            if (diagonal_[k] == 0.0 || !std::isfinite(diagonal_[k])) return {.negatives = inertia.negatives, .singular = true};
            eliminate_one(a, k);
        } else {
            sizes_[k + 1] = 0;
            diagonal_[k + 1] = a(k + 1, k + 1);
            off_diagonal_[k] = a(k + 1, k);
            a(k + 1, k) = 0.0;         // L has a unit block here
            inertia.negatives += 1;    // Bunch and Kaufman take a pair only where its determinant is negative
            eliminate_two(a, k);
        }
        k += size;
    }
    return inertia;
}

void PartialLdlt::reduce(const Eigen::Ref<const MatrixX>& a, Eigen::Ref<VectorX> b) const {
    const auto n = static_cast<int>(a.rows());
    for (int k = 0; k < eliminated_; ++k) std::swap(b[k], b[swaps_[k]]);
    for (int k = 0; k < eliminated_; ++k) {
        const int first_below = k + (sizes_[k] == 2 ? 2 : 1);
        b.tail(n - first_below) -= b[k] * a.col(k).tail(n - first_below);
    }
}

void PartialLdlt::substitute(const Eigen::Ref<const MatrixX>& a, const Eigen::Ref<const VectorX>& b,
                             Eigen::Ref<VectorX> x) const {
    const auto n = static_cast<int>(a.rows());
    for (int k = 0; k < eliminated_; ++k) {    // −D⁻¹ y
        if (sizes_[k] == 1) {
            x[k] = -b[k] / diagonal_[k];
        } else if (sizes_[k] == 2) {
            const double determinant = diagonal_[k] * diagonal_[k + 1] - off_diagonal_[k] * off_diagonal_[k];
            x[k] = -(diagonal_[k + 1] * b[k] - off_diagonal_[k] * b[k + 1]) / determinant;
            x[k + 1] = -(diagonal_[k] * b[k + 1] - off_diagonal_[k] * b[k]) / determinant;
        }
    }
    for (int k = eliminated_ - 1; k >= 0; --k) {    // L11ᵀ x1 = −D⁻¹ y − L21ᵀ x2
        const int first_below = k + (sizes_[k] == 2 ? 2 : 1);
        x[k] -= a.col(k).tail(n - first_below).dot(x.tail(n - first_below));
    }
    for (int k = eliminated_ - 1; k >= 0; --k) std::swap(x[k], x[swaps_[k]]);
}

}    // namespace stylet::core
