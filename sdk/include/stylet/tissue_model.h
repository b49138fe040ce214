#pragma once

#include <stylet/body.h>
#include <stylet/patch.h>

namespace stylet {

inline constexpr int outside = -1;

/// What a material point of the undeformed tissue lies in. A point on an interface belongs to the layer below it.
struct Location {
    int layer = outside;    // index from the top, or `outside`
    double depth = 0.0;     // [m] below the undeformed surface, negative above it
};

/// A tissue: a body that knows its layers and its undeformed surface.
class TissueModel : public Body {
public:
    static constexpr Role role = Role::tissue;

    /// Moves the tissue under everything already known for `dt` [s], on from the latest trial state. dt = 0: core solves again at
    /// one instant, nothing moves on. That is how it begins too: where a tissue has inertia, it is let go in the first step that
    /// takes time.
    virtual void predict(double dt) = 0;

    /// The patches that the scene's effects load, told before anything else. Each call replaces the last; the span doesn't
    /// outlive it. A force on a patch is shared evenly by what it covers (its area, its nodes). Throws Error where this tissue
    /// can't be loaded there.
    virtual void bear(std::span<const Patch> patches) {
        if (!patches.empty()) throw Error("this tissue bears no load on a patch of its surface");
    }

    /// From the next predict on, the force on each of those patches [N].
    virtual void load(std::span<const Vector3>) {}

    /// Mean displacement of patch i [m], of the latest trial state: the way that a force on it works along.
    [[nodiscard]] virtual Vector3 patch_displacement(int) const { return Vector3::Zero(); }

    /// Of a material point [m], of the committed state: what a picture shows.
    [[nodiscard]] virtual Vector3 displacement(const Vector3& material) const = 0;

    [[nodiscard]] virtual Location locate(const Vector3& material) const = 0;

    /// Where the way from `from` to `to` first enters the undeformed tissue: a fraction in [0, 1], or −1 where it does not.
    [[nodiscard]] virtual double entry(const Vector3& from, const Vector3& to) const = 0;

    /// Names what the committed state cannot vouch for (a dent deeper than the block): text that lives with the library, or
    /// nullptr.
    [[nodiscard]] virtual const char* beyond_validity() const { return nullptr; }
};

}    // namespace stylet
