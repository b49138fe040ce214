#pragma once

#include <stylet/setup.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace stylet {

/// The elasticity of stacked layers as a contact of a needle's size feels it at a depth: the layer's own, blended over four radii
/// on either side of each interface, Young's modulus geometrically. A tip that crosses one feels it come.
class LayeredElasticity {
public:
    /// A tip as large as a radius feels an interface from about this many radii away.
    static constexpr double interface_radii = 4.0;

    /// `layers` must outlive it; `radius` of the needle [m], zero where there is none.
    LayeredElasticity(const std::vector<Layer>& layers, double radius)
        : layers_(layers), half_width_(std::max(sharp, interface_radii * radius)) {}

    /// Young's modulus [Pa] at `depth` below the undeformed surface [m].
    [[nodiscard]] double modulus(double depth) const {
        double modulus = layers_.front().youngs_modulus;
        for_each_interface(depth, [&](const Layer& above, const Layer& below, double share) {
            modulus *= std::pow(below.youngs_modulus / above.youngs_modulus, share);
        });
        return modulus;
    }

    /// At `depth` below the undeformed surface [m].
    [[nodiscard]] double poisson_ratio(double depth) const {
        double ratio = layers_.front().poisson_ratio;
        for_each_interface(depth, [&](const Layer& above, const Layer& below, double share) {
            ratio += share * (below.poisson_ratio - above.poisson_ratio);
        });
        return ratio;
    }

private:
    static constexpr double sharp = 1e-9;    // [m] half the blend where there is no needle to feel it

    /// Calls visit(above, below, share) with how much of the step from one layer to the next is felt at `depth`.
    template <typename Visit>
    void for_each_interface(double depth, Visit visit) const {
        double bottom = 0.0;    // [m] depth of the layer's
        for (std::size_t i = 0; i + 1 < layers_.size(); ++i) {
            bottom += layers_[i].thickness;
            const double t = std::clamp(0.5 * (1.0 + (depth - bottom) / half_width_), 0.0, 1.0);
            visit(layers_[i], layers_[i + 1], t * t * (3.0 - 2.0 * t));
        }
    }

    const std::vector<Layer>& layers_;
    double half_width_;    // [m]
};

}    // namespace stylet
