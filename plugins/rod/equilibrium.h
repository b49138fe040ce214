// For tests: a chain at rest under dead loads, springs and held unknowns, by Newton's method.
#pragma once

#include "chain.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

namespace stylet::rod {

/// Finds where ∇U(x) + k x = load, but for the unknowns that are held. The tensions are mixed as in rod.cpp. A held unknown has
/// an infinite pivot: to rounding it is eliminated, and the negative pivots are those of the free ones.
class Equilibrium {
public:
    explicit Equilibrium(const ChainSetup& setup)
        : chain(setup),
          shape(chain.straight()),
          load(VectorX::Zero(chain.unknowns())),
          springs(VectorX::Zero(chain.unknowns())),
          tensions_(chain.edges(), 0.0),
          tangent_(chain.unknowns()),
          gradient_(VectorX::Zero(chain.unknowns())) {}

    Chain chain;
    Shape shape;
    VectorX load;                  // [N], [N·m]
    VectorX springs;               // [N/m] against each node's displacement; of angles zero
    std::map<int, double> held;    // [m] a node's unknown, and the displacement it is kept at
    /// Adds the ∇ and ∇² of whatever else has a potential.
    std::function<void(const Shape&, VectorX& gradient, BandLdlt& tangent)> further;

    static constexpr int x = 0, y = 1, z = 2;    // of a node's unknowns
    [[nodiscard]] static int unknown(int node, int direction) { return Chain::unknown_of(node) + direction; }
    [[nodiscard]] int last() const { return chain.edges(); }    // node
    [[nodiscard]] Vector3 place(int node) const {               // [m]
        return node * chain.edge_length() * Chain::axis + shape.displacement[node];
    }

    [[nodiscard]] double displacement(int node, int direction) const { return shape.displacement[node][direction]; }    // [m]

    /// From the shape at hand, until a step moves no node by more than `close` [m]: what it would still move after that is its
    /// square. Forces tell less, for the last bit of a place stands for a force in all but unstretchable edges. False where it
    /// does not get there.
    [[nodiscard]] bool solve(double close) { return descend(close, false); }
    [[nodiscard]] bool solve() { return solve(1e-10 * chain.setup().length); }

    /// The same, on a stable branch: a tangent with negative eigenvalues is made stiffer until it has none, as a tick does with
    /// its masses, so that every step lowers the energy.
    [[nodiscard]] bool settle() { return descend(1e-10 * chain.setup().length, true); }

    /// How many ways it would leave the shape at hand: negative eigenvalues of the tangent, by Sylvester's law.
    [[nodiscard]] int negatives() {
        for (int e = 0; e < chain.edges(); ++e) tensions_[e] = chain.tension(shape, e);
        return negatives_at(tensions_);
    }

    /// The same with these tensions [N] of the edges instead of their own.
    [[nodiscard]] int negatives_at(const std::vector<double>& tensions) {
        tensions_ = tensions;
        VectorX rest = assemble();
        add_held(rest);
        return tangent_.factor();
    }

    /// [N] with which an unknown is held.
    [[nodiscard]] double reaction(int held_unknown) { return -assemble()[held_unknown]; }

private:
    [[nodiscard]] bool descend(double close, bool stable) {
        constexpr int most_steps = 400;
        constexpr double largest_turn = 0.3;    // [rad] of an edge in a step
        for (int i = 0; i < most_steps; ++i) {
            VectorX step = assemble();
            add_held(step);
            int negatives = tangent_.factor();
            for (double stiffer = least_stiffness(); stable && negatives > 0; stiffer *= 2.0) {
                step = assemble();
                for (int node = 1; node <= last(); ++node) {
                    for (int a = unknown(node, x); a <= unknown(node, z); ++a) tangent_.add(a, a, stiffer);
                }
                add_held(step);
                negatives = tangent_.factor();
            }
            tangent_.solve(step);
            if (!step.allFinite()) return false;
            const double part = std::min(1.0, largest_turn / turn(step));
            step *= part;
            for (int e = 0; e < chain.edges(); ++e) tensions_[e] = chain.tension(shape, e) + chain.tension_change(shape, step, e);
            chain.move(step, shape);
            if (part == 1.0 && farthest(step) <= close) return true;
        }
        return false;
    }

    // [N/m] of a node, to begin with: a share of the rod's own against a bow.
    [[nodiscard]] double least_stiffness() const {
        const ChainSetup& setup = chain.setup();
        return 0.1 * setup.section.bending.minCoeff() / std::pow(setup.length, 3) / setup.edges;
    }

    // The tangent, and load − ∇U − k x.
    VectorX assemble() {
        static const Viscosity none{.rate = 0.0, .before = nullptr};
        tangent_.clear();
        chain.linearise(shape, tensions_, none, tangent_, gradient_);
        if (further) further(shape, gradient_, tangent_);
        VectorX rest = load - gradient_;
        for (int a = 0; a < chain.unknowns(); ++a) {
            if (springs[a] == 0.0) continue;
            tangent_.add(a, a, springs[a]);
            rest[a] -= springs[a] * displaced(a);
        }
        return rest;
    }

    [[nodiscard]] double displaced(int unknown) const { return shape.displacement[unknown / 4 + 1][unknown % 4]; }

    void add_held(VectorX& rest) {
        constexpr double infinite = 1e40;    // [N/m] its square is still finite
        for (const auto& [unknown, at] : held) {
            tangent_.add(unknown, unknown, infinite);
            rest[unknown] = infinite * (at - displaced(unknown));
        }
    }

    // [m] that a step moves a node by, in one direction.
    [[nodiscard]] double farthest(const VectorX& step) const {
        double largest = 0.0;
        for (int node = 1; node <= last(); ++node)
            largest = std::max(largest, step.segment<3>(Chain::unknown_of(node)).cwiseAbs().maxCoeff());
        return largest;
    }

    // [rad] that a step turns an edge by, or its material about it.
    [[nodiscard]] double turn(const VectorX& step) const {
        double largest = 1e-300;
        Vector3 before = Vector3::Zero();
        for (int node = 1; node <= last(); ++node) {
            const Vector3 now = step.segment<3>(Chain::unknown_of(node));
            largest =
                std::max({largest, (now - before).norm() / chain.edge_length(), std::abs(step[Chain::unknown_of(node) + 3])});
            before = now;
        }
        return largest;
    }

    std::vector<double> tensions_;    // [N]
    BandLdlt tangent_;
    VectorX gradient_;
};

/// A straight one of unit length and bending stiffness, stretched by less than 1e-7 under loads up to `load` [EI/L²].
[[nodiscard]] inline ChainSetup unit_rod(int elements, bool clamped, double load) {
    return {.edges = elements,
            .length = 1.0,
            .section = {.stretching = 1e7 * (10.0 + load), .bending = {1.0, 1.0}, .twisting = 0.8},
            .clamped = clamped,
            .natural_curvature = std::vector(elements, 0.0)};
}

/// Holds the last node on the axis.
inline void pin_tip(Equilibrium& rod) {
    for (const int side : {Equilibrium::x, Equilibrium::y}) rod.held[rod.unknown(rod.last(), side)] = 0.0;
}

/// Bows a straight rod toward x until its last node is `span` [m] from its base, along its axis. Where the bow is free to turn
/// about that axis, `kept_in_plane` is a node that keeps it from it. False where it found no rest on the way.
[[nodiscard]] inline bool bow(Equilibrium& rod, int kept_in_plane, double span) {
    constexpr int steps = 20;
    const ChainSetup& setup = rod.chain.setup();
    const int push = rod.unknown(kept_in_plane, Equilibrium::x);
    rod.held[rod.unknown(kept_in_plane, Equilibrium::y)] = 0.0;
    rod.load[push] = setup.section.bending[0] / (setup.length * setup.length);    // it has to take a side
    bool found = rod.solve();
    for (int step = 1; step <= steps; ++step) {
        rod.held[rod.unknown(rod.last(), Equilibrium::z)] = (setup.length - span) * step / steps;
        found = found && rod.solve();
        rod.load[push] = 0.0;
    }
    return found && rod.solve();
}

}    // namespace stylet::rod
