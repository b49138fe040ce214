#include "contact/regions_felt.h"

#include <stylet/layered_elasticity.h>

#include <cmath>
#include <numbers>

namespace stylet::corotational_fem {

// Heights from one end of the ball to the other, turned by the golden angle from one to the next (Vogel 1979), at radii that fill
// it evenly: no two points meet an interface at once.
RegionsFelt::RegionsFelt(const Mesh& mesh, const Locator& locator, const std::vector<Layer>& layers, double radius)
    : mesh_(mesh), locator_(locator), layers_(layers) {
    const double golden = std::numbers::pi * (3.0 - std::sqrt(5.0));
    const auto count = static_cast<double>(samples_.size());
    for (std::size_t i = 0; i < samples_.size(); ++i) {
        const double height = 1.0 - 2.0 * (static_cast<double>(i) + 0.5) / count, across = std::sqrt(1.0 - height * height);
        const double angle = golden * static_cast<double>(i);
        // Seven and sixty-four have no common factor: neighbours in height lie at different radii.
        const double reach = std::cbrt((static_cast<double>(7 * i % samples_.size()) + 0.5) / count);
        samples_[i] = LayeredElasticity::interface_radii * radius * reach *
                      Vector3(across * std::cos(angle), across * std::sin(angle), height);
    }
}

Felt RegionsFelt::at(const Vector3& point) const {
    double log_modulus = 0.0, poisson_ratio = 0.0;
    int inside = 0;
    for (const Vector3& sample : samples_) {
        const int tetrahedron = locator_.find(point + sample).tetrahedron;
        if (tetrahedron == no_tetrahedron) continue;
        const Layer& layer = layers_[mesh_.layers[tetrahedron]];
        log_modulus += std::log(layer.youngs_modulus);
        poisson_ratio += layer.poisson_ratio;
        ++inside;
    }
    if (inside == 0) return {layers_.front().youngs_modulus, layers_.front().poisson_ratio};
    return {std::exp(log_modulus / inside), poisson_ratio / inside};
}

}    // namespace stylet::corotational_fem
