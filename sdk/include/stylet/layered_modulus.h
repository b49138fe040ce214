#pragma once

#include <stylet/setup.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace stylet {

/// Young's modulus of stacked layers as a contact of a needle's size feels it at a depth [Pa]: the layer's own, blended
/// geometrically over four radii on either side of each interface. A tip that crosses one feels it come.
class LayeredModulus {
public:
    /// `layers` must outlive it; `radius` of the needle [m], zero where there is none.
    LayeredModulus(const std::vector<Layer>& layers, double radius)
        : layers_(layers), half_width_(std::max(sharp, interface_radii * radius)) {}

    /// At `depth` below the undeformed surface [m].
    [[nodiscard]] double operator()(double depth) const {
        double modulus = layers_.front().youngs_modulus;
        double bottom = 0.0;    // [m] depth of the layer's
        for (std::size_t i = 0; i + 1 < layers_.size(); ++i) {
            bottom += layers_[i].thickness;
            const double t = std::clamp(0.5 * (1.0 + (depth - bottom) / half_width_), 0.0, 1.0);
            modulus *= std::pow(layers_[i + 1].youngs_modulus / layers_[i].youngs_modulus, t * t * (3.0 - 2.0 * t));
        }
        return modulus;
    }

private:
    // A tip as large as a radius feels an interface from about this many radii away.
    static constexpr double interface_radii = 4.0;
    static constexpr double sharp = 1e-9;    // [m] half the blend where there is no needle to feel it

    const std::vector<Layer>& layers_;
    double half_width_;    // [m]
};

}    // namespace stylet
