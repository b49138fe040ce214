// What a force on a footprint does, without a whole solve.
#pragma once

#include "fast/panels.h"
#include "solver.h"

#include <span>
#include <vector>

namespace stylet::corotational_fem {

/// Three unit loads, along x, y and z, shared out over a footprint's nodes by its weights, swept forward through a Panels.
///
/// A forward sweep changes nothing but the supernodes from the footprint's up to the root: b_s, what is left of a load at
/// each of them. With those of two footprints,
///     w_iᵀ A⁻¹ w_j = Σ_s b_isᵀ S_s⁻¹ b_js,
/// over the supernodes that both have. Works with Panels' own blocks, so that it agrees with its solves to single precision.
/// Nothing allocates, locks or throws but the constructor.
class Reach {
public:
    /// Of no footprint as yet. The panels must outlive it. Takes room for a footprint on all nodes.
    explicit Reach(Panels& panels);

    /// Of this footprint from now on.
    void sweep(std::span<const NodeWeight> footprint);

    /// [m/N] How far this footprint moves, on average, for unit forces on the other; the other way round it is the transpose.
    /// Symmetric, bit for bit, of a footprint with itself.
    [[nodiscard]] Matrix3 compliance(const Reach& other) const;

    /// [m] How far the footprint moves, on average, in the solve whose forward half has been done.
    [[nodiscard]] Vector3 displacement() const;

    /// Adds a force [N] on the footprint to the solve whose forward half has been done.
    void push(const Vector3& force) const;

private:
    struct Stop {
        int supernode;
        int lines;    // of one column
        int at;       // [lines] in loads_ and answers_, where its three columns begin
    };

    void find_path(std::span<const NodeWeight> footprint);
    void load(std::span<const NodeWeight> footprint);
    void climb(const Stop& stop);
    [[nodiscard]] float* loads(int at) { return reinterpret_cast<float*>(loads_.data() + at); }
    [[nodiscard]] float* answers(int at) { return reinterpret_cast<float*>(answers_.data() + at); }
    [[nodiscard]] const float* loads(int at) const { return reinterpret_cast<const float*>(loads_.data() + at); }
    [[nodiscard]] const float* answers(int at) const { return reinterpret_cast<const float*>(answers_.data() + at); }

    Panels& panels_;
    std::vector<Panels::Line> loads_, answers_;    // b_s and S_s⁻¹ b_s of each stop, three columns padded to whole tiles
    std::vector<Panels::Line> rows_;               // room for three columns of M b_s
    std::vector<Stop> path_;                       // supernodes ascending; of its room the first stops_
    int stops_ = 0;
    std::vector<int> stop_;    // of each supernode, which stop it is; −1: none
};

}    // namespace stylet::corotational_fem
