// A contact as a tissue without a mesh of the needle's size sees it: a few points that share its force.
#pragma once

#include <stylet/body.h>

#include <array>
#include <span>

namespace stylet {

/// The points that share a contact's force evenly: the tip itself, or eight along a shaft contact's piece of track. A fixed
/// number: what is averaged over them then changes smoothly while the piece grows.
class Footprint {
public:
    static constexpr int shaft_samples = 8;

    Footprint() = default;
    explicit Footprint(const ContactPoint& point) : point_(point), count_(point.tip ? 1 : shaft_samples) {
        for (int i = 0; i < count_; ++i) samples_[i] = point.material + (i + 0.5) / count_ * point.span;
    }

    [[nodiscard]] const ContactPoint& point() const { return point_; }
    [[nodiscard]] std::span<const Vector3> samples() const { return {samples_.data(), static_cast<std::size_t>(count_)}; }
    [[nodiscard]] Vector3 middle() const { return point_.material + 0.5 * point_.span; }    // [m]

    /// Whether this is the footprint of `point` too. The needle's arclength at a contact means nothing to the tissue.
    [[nodiscard]] bool is_of(const ContactPoint& point) const {
        return point_.material == point.material && point_.span == point.span && point_.tip == point.tip;
    }

private:
    ContactPoint point_{};
    std::array<Vector3, shaft_samples> samples_;    // [m]
    int count_ = 0;
};

}    // namespace stylet
