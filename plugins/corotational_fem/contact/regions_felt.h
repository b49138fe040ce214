// What material a contact of a needle's size feels where a mesh, not a stack of layers, says what is where.
#pragma once

#include "mesh/locator.h"

#include <stylet/setup.h>

#include <array>

namespace stylet::corotational_fem {

struct Felt {
    double youngs_modulus;    // [Pa]
    double poisson_ratio;
};

/// The mean over a ball of four radii of the needle, Young's modulus geometrically, over what of it is in the mesh: by sixty-four
/// points evenly spread, so that a tip that crosses an interface feels it come in as many small steps. LayeredElasticity is the
/// same for stacked layers, in closed form.
class RegionsFelt {
public:
    /// All must outlive it; `radius` of the needle [m].
    RegionsFelt(const Mesh& mesh, const Locator& locator, const std::vector<Layer>& layers, double radius);

    /// About a material point [m]; of the first layer where none of the ball is in the mesh. Allocates nothing.
    [[nodiscard]] Felt at(const Vector3& point) const;

private:
    const Mesh& mesh_;
    const Locator& locator_;
    const std::vector<Layer>& layers_;
    std::array<Vector3, 64> samples_;    // [m] from the point
};

}    // namespace stylet::corotational_fem
