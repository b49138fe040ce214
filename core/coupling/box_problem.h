#pragma once

#include "core/coupling/partial_ldlt.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace stylet::core {

/// Contact forces in their boxes: finds λ with
///
///     v = A λ + b,    λ = lower and v ≥ 0,   or   lower < λ < upper and v = 0,   or   λ = upper and v ≤ 0
///
/// for the last rows, and v = 0 with λ unbounded for the first `bilateral` rows. A is symmetric and may be indefinite. The
/// bilateral rows go first (PartialLdlt), the rest is solved exactly by an active set that starts from the last one: principal
/// pivoting on all wrong rows at once (Júdice and Pires 1994 with two bounds), or on the last wrong one alone (Murty 1974) where
/// that doesn't shrink their number. That always ends where what is left of A is positive definite; where a needle is past its
/// limit load it is not, and after some sets nothing is found. The answer is that of a linear system, so it doesn't depend on how
/// many sets were tried; where it is not convex there may be several, and the one nearest to the last set is found.
class BoxProblem {
public:
    explicit BoxProblem(int max_rows);

    struct Outcome {
        int negatives = 0;      // of the rows that are not at a bound
        bool convex = true;     // none of them is the boxed rows'
        bool solved = false;    // false: singular, or no set found
        int sets = 0;           // active sets tried
    };

    /// `a` (n × n, lower triangle; overwritten), `b`, `lower`, `upper` (n; the first `bilateral` bounds are not read), `lambda`
    /// (n; out). Row i of the box keeps its place in the active set from call to call.
    Outcome solve(Eigen::Ref<MatrixX> a, Eigen::Ref<VectorX> b, const Eigen::Ref<const VectorX>& lower,
                  const Eigen::Ref<const VectorX>& upper, int bilateral, Eigen::Ref<VectorX> lambda);

private:
    enum class Place : std::uint8_t { lower, free, upper };

    bool find_set(const Eigen::Ref<const MatrixX>& s, const Eigen::Ref<const VectorX>& b, const Eigen::Ref<const VectorX>& lower,
                  const Eigen::Ref<const VectorX>& upper, Eigen::Ref<VectorX> lambda, int& sets);
    bool solve_free(const Eigen::Ref<const MatrixX>& s, const Eigen::Ref<const VectorX>& b, Eigen::Ref<VectorX> lambda);
    Place wanted(int row, double lower, double upper, double lambda, double slack) const;
    int judge(const Eigen::Ref<const VectorX>& lower, const Eigen::Ref<const VectorX>& upper,
              const Eigen::Ref<const VectorX>& lambda, double slack);

    PartialLdlt bilateral_;
    PartialLdlt inner_;
    std::vector<Place> places_;
    std::vector<Place> wanted_;
    std::vector<int> free_rows_;
    int free_negatives_ = 0;    // of the free rows' block, the bilateral rows eliminated
    MatrixX system_;            // of the free rows
    VectorX right_;             // b + S λ_bounded, then reduced
    VectorX unknown_;
    VectorX v_;    // A λ + b of the box rows
};

}    // namespace stylet::core
