// A body in place for its checks: made, moved to where the case wants it, with contact points to press on.
#pragma once

#include <stylet/contract/plugin.h>

#include <functional>
#include <vector>

namespace stylet::contract {

struct Rig {
    std::unique_ptr<Object> object;
    Body* body = nullptr;
    TissueModel* tissue = nullptr;    // one of these two is the body
    NeedleModel* needle = nullptr;
    double dt = 0.0;             // [s]
    double length = 0.0;         // [m] the needle's
    double free_length = 0.0;    // [m]
    Pose base;
    Vector3 axis;                        // unit, toward the tip
    std::vector<ContactPoint> points;    // the shaft's from the surface down, then the tip
    VectorX load;                        // 3n, [N] the case's load on this body

    void predict() const {
        if (tissue != nullptr) tissue->predict(dt);
        if (needle != nullptr) needle->predict(base, free_length, dt);
    }

    /// Repeats linearise and try_step until the body is in balance; false where it does not get there.
    [[nodiscard]] bool converge(const VectorX& forces) const;

    /// One tick with these forces.
    [[nodiscard]] bool advance(const VectorX& forces) const;

    /// Where the contacts are under these forces, 3n [m], about the latest trial state.
    [[nodiscard]] VectorX positions(const VectorX& forces) const;

    [[nodiscard]] Forces view(const VectorX& forces) const { return {forces.data(), forces.size()}; }
};

/// A body of the case whose tip is `depth` [m] inside the tissue, with a shaft contact for every `spacing` [m] of its track.
[[nodiscard]] Rig make_rig(const Descriptor& plugin, const Case& with, double depth, double spacing);

/// Runs a check with the tip on the surface, then with it inside.
void at_both_depths(const Descriptor& plugin, const Case& with, const std::function<void(Rig&)>& check);

/// Everything the body answers, in the order it was asked, to compare two states bit for bit.
[[nodiscard]] std::vector<double> answers(const Rig& rig);

/// True where both hold the same bits: −0 differs from 0, a NaN equals itself.
[[nodiscard]] bool same_bits(const std::vector<double>& a, const std::vector<double>& b);

[[nodiscard]] bool all_finite(const std::vector<double>& values);

}    // namespace stylet::contract
