#pragma once

#include <stylet/body.h>

namespace stylet {

/// What a recording and a summary say of a needle's committed state.
struct NeedleState {
    double critical_load = 0.0;    // [N] of the free length, by a formula; infinite where the needle asks none
    double axial_load = 0.0;       // [N] compression that the free length carries
    double deflection = 0.0;       // [m] largest distance from the straight line
    double slope = 0.0;            // [rad] largest angle to the straight line
    bool buckled = false;
};

/// A needle: a body held at its base.
class NeedleModel : public Body {
public:
    static constexpr Role role = Role::needle;

    /// Moves the base and everything already known. `free_length` [m] runs from the base to where the shaft crosses the surface,
    /// the whole length before puncture. `dt` [s] is zero when core solves again at the same instant, and when it tells of the
    /// free length that a step has led to, just before commit: nothing may move then.
    virtual void predict(const Pose& base, double free_length, double dt) = 0;

    [[nodiscard]] virtual Vector3 position(
        double arclength) const = 0;    // [m] of the latest trial state, arclength from the base
    [[nodiscard]] virtual Vector3 tangent(double arclength) const = 0;    // unit, toward the tip

    /// The same of a point that is in the track, or of the tip: a needle whose bow ends at the mouth keeps it straight there.
    [[nodiscard]] virtual Vector3 held_position(double arclength) const { return position(arclength); }
    [[nodiscard]] virtual Vector3 held_tangent(double arclength) const { return tangent(arclength); }

    /// Unit, the way in which the tip cuts, and slides back: straight on for most, aside of its axis for a bevelled one.
    [[nodiscard]] virtual Vector3 cut_direction(double length) const { return held_tangent(length); }

    /// The configurational force with which the mouth of the track pushes the needle out because a longer free length stores its
    /// bow more cheaply: −∂U/∂L at fixed shortening [N], of the latest trial state (Bigoni et al. 2015). Zero for most needles.
    [[nodiscard]] virtual double entry_force() const { return 0.0; }

    /// What the hand must apply to the committed needle, about its base.
    [[nodiscard]] virtual Wrench base_wrench() const = 0;

    [[nodiscard]] virtual NeedleState state() const = 0;

    /// Points of the committed centre line from base to tip, evenly spaced in arclength.
    virtual void centreline(std::span<Vector3> points) const = 0;

    /// Names what the committed state cannot vouch for (a slope over 45°): text that lives with the library, or nullptr.
    [[nodiscard]] virtual const char* beyond_validity() const { return nullptr; }
};

}    // namespace stylet
