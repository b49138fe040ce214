#include "core/coupling/box_problem.h"

#include <algorithm>
#include <cmath>

namespace stylet::core {

namespace {

// After this many sets whose number of wrong rows did not shrink, rows change one at a time.
constexpr int patience = 4;
constexpr int most_sets = 2000;
constexpr int most_indefinite_sets = 50;    // no theorem says that one is found
// A force this far outside its box, relative to the box's scale, is rounding: it must not start another set.
constexpr double rounding = 1e-12;

}    // namespace

BoxProblem::BoxProblem(int max_rows)
    : bilateral_(max_rows),
      inner_(max_rows),
      places_(max_rows, Place::free),
      wanted_(max_rows, Place::free),
      system_(max_rows, max_rows),
      right_(max_rows),
      unknown_(max_rows),
      v_(max_rows) {
    free_rows_.reserve(max_rows);
}

bool BoxProblem::solve_free(const Eigen::Ref<const MatrixX>& s, const Eigen::Ref<const VectorX>& b, Eigen::Ref<VectorX> lambda) {
    const auto n = static_cast<int>(s.rows());
    free_rows_.clear();
    for (int i = 0; i < n; ++i) {
        if (places_[i] == Place::free) free_rows_.push_back(i);
    }
    v_.head(n) = b;
    for (int j = 0; j < n; ++j) {    // S λ of the bounded rows, from the lower triangle
        if (places_[j] == Place::free || lambda[j] == 0.0) continue;
        v_.segment(j, n - j) += lambda[j] * s.col(j).tail(n - j);
        v_.head(j) += lambda[j] * s.row(j).head(j).transpose();
    }
    const auto count = static_cast<int>(free_rows_.size());
    free_negatives_ = 0;
    if (count == 0) return true;
    auto system = system_.topLeftCorner(count, count);
    auto right = right_.head(count);
    auto unknown = unknown_.head(count);
    for (int i = 0; i < count; ++i) {
        right[i] = v_[free_rows_[i]];
        for (int j = 0; j <= i; ++j) system(i, j) = s(free_rows_[i], free_rows_[j]);
    }
    const PartialLdlt::Inertia inertia = inner_.eliminate(system, count);
    if (inertia.singular) return false;
    free_negatives_ = inertia.negatives;
    inner_.reduce(system, right);
    inner_.substitute(system, right, unknown);
    for (int i = 0; i < count; ++i) {
        const int row = free_rows_[i];
        lambda[row] = unknown[i];
        v_.segment(row, n - row) += unknown[i] * s.col(row).tail(n - row);
        v_.head(row) += unknown[i] * s.row(row).head(row).transpose();
    }
    return unknown.allFinite();
}

BoxProblem::Place BoxProblem::wanted(int row, double lower, double upper, double lambda, double slack) const {
    if (lower == upper) return Place::lower;
    if (places_[row] == Place::free) {
        const double tolerance = rounding * std::abs(lambda);
        if (lambda < lower - tolerance) return Place::lower;
        return lambda > upper + tolerance ? Place::upper : Place::free;
    }
    if (places_[row] == Place::lower) return v_[row] < -slack ? Place::free : Place::lower;
    return v_[row] > slack ? Place::free : Place::upper;
}

// Fills wanted_; returns how many rows are in the wrong place.
int BoxProblem::judge(const Eigen::Ref<const VectorX>& lower, const Eigen::Ref<const VectorX>& upper,
                      const Eigen::Ref<const VectorX>& lambda, double slack) {
    int wrong = 0;
    for (int i = 0; i < lambda.size(); ++i) {
        wanted_[i] = wanted(i, lower[i], upper[i], lambda[i], slack);
        wrong += wanted_[i] != places_[i];
    }
    return wrong;
}

bool BoxProblem::find_set(const Eigen::Ref<const MatrixX>& s, const Eigen::Ref<const VectorX>& b,
                          const Eigen::Ref<const VectorX>& lower, const Eigen::Ref<const VectorX>& upper,
                          Eigen::Ref<VectorX> lambda, int& sets) {
    const auto n = static_cast<int>(s.rows());
    if (n == 0) return true;
    for (int i = 0; i < n; ++i) {    // an unbounded side can hold no row
        if (lower[i] == upper[i] || (places_[i] == Place::upper && std::isinf(upper[i]))) places_[i] = Place::lower;
        if (places_[i] == Place::lower && std::isinf(lower[i])) places_[i] = Place::free;
    }
    int fewest = n + 1, patience_left = patience, most = most_sets;
    for (sets = 1; sets <= most; ++sets) {
        for (int i = 0; i < n; ++i) {
            if (places_[i] != Place::free) lambda[i] = places_[i] == Place::lower ? lower[i] : upper[i];
        }
        if (!solve_free(s, b, lambda)) return false;
        if (free_negatives_ > 0) most = most_indefinite_sets;
        const double slack = rounding * s.diagonal().cwiseAbs().maxCoeff() * lambda.cwiseAbs().sum();
        const int wrong = judge(lower, upper, lambda, slack);
        if (wrong == 0) return true;
        if (wrong < fewest) {
            fewest = wrong;
            patience_left = patience;
        } else {
            --patience_left;
        }
        for (int i = n - 1; i >= 0; --i) {
            if (wanted_[i] == places_[i]) continue;
            places_[i] = wanted_[i];
            if (patience_left < 0) break;    // Murty: the last wrong row alone
        }
    }
    return false;
}

BoxProblem::Outcome BoxProblem::solve(Eigen::Ref<MatrixX> a, Eigen::Ref<VectorX> b, const Eigen::Ref<const VectorX>& lower,
                                      const Eigen::Ref<const VectorX>& upper, int bilateral, Eigen::Ref<VectorX> lambda) {
    const auto boxed = static_cast<int>(a.rows()) - bilateral;
    const PartialLdlt::Inertia inertia = bilateral_.eliminate(a, bilateral);
    Outcome outcome{.negatives = inertia.negatives};
    if (inertia.singular) return outcome;
    bilateral_.reduce(a, b);
    outcome.solved = find_set(a.bottomRightCorner(boxed, boxed), b.tail(boxed), lower.tail(boxed), upper.tail(boxed),
                              lambda.tail(boxed), outcome.sets);
    if (!outcome.solved) return outcome;
    if (boxed > 0) outcome.negatives += free_negatives_;
    outcome.convex = boxed == 0 || free_negatives_ == 0;
    bilateral_.substitute(a, b, lambda);
    outcome.solved = lambda.allFinite() && v_.head(boxed).allFinite();    // NaN compares as if every row were in its place
    return outcome;
}

}    // namespace stylet::core
