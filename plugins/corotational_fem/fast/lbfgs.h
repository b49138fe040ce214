// What the last few steps of a quasi-Newton solver have taught about the true stiffness.
#pragma once

#include "fast/nodal.h"

#include <array>

namespace stylet::corotational_fem {

/// An inverse stiffness H that agrees with the last pairs (s, y) of a step s and the change y of force along it, H y = s for the
/// newest, and with an inverse A⁻¹ that the caller applies in every other respect:
///
///     q = begin(r),   H r = finish(A⁻¹ q)
///
/// Positive definite where A is and every pair's curvature s·y is positive. Source: Nocedal 1980 (the two-loop recursion); here
/// with the pairs' products kept, so that each half reads every vector only twice.
///
/// Allocates when made, never later.
class Lbfgs {
public:
    static constexpr int most = 3;    // pairs; more have taught nothing

    explicit Lbfgs(const NodeLoops& loops);

    /// Where the caller writes the next pair, to be kept or overwritten.
    [[nodiscard]] Float4* step() { return steps_[spare()].data(); }
    [[nodiscard]] Float4* change() { return changes_[spare()].data(); }

    /// What has been written there becomes the newest pair, `curvature` = s·y > 0; the oldest goes.
    void keep(double curvature);

    void forget() { trial_.count = 0; }
    void commit() { state_ = trial_; }
    void rollback() { trial_ = state_; }    // the pairs of the last commit, bit for bit
    [[nodiscard]] int count() const { return trial_.count; }

    void begin(const Float4* r, Float4* q);
    void finish(const Float4* answer, Float4* z) const;

private:
    static constexpr int slots = 2 * most + 1;    // for the pairs of now, those of the last commit and the next

    struct Known {
        std::array<int, most> slots{};    // of the pairs, oldest first
        int count = 0;
    };

    [[nodiscard]] int spare() const;
    template <int count>
    void multiply_next();
    template <int count>
    void begin_with(const Float4* r, Float4* q);
    template <int count>
    void finish_with(const Float4* answer, Float4* z) const;

    NodeLoops loops_;
    Known trial_, state_;
    std::array<NodalVector, slots> steps_, changes_;             // s and y
    std::array<std::array<double, slots>, slots> products_{};    // s_i · y_j
    std::array<double, most> taken_{};                           // α of the last begin, oldest first
};

}    // namespace stylet::corotational_fem
