#include "still_bodies.h"

namespace {

using stylet::still::Tissue;

constexpr stylet::Parameter parameters[] = {
    stylet::vector3("cells", "1", "number of cells along x, y, z"),
    stylet::optional(stylet::number("damping", "1/s", stylet::not_negative, "mass damping; left out, there is none")),
};

}    // namespace

STYLET_PLUGIN(Tissue, "lattice", parameters, .summary = "A tissue with parameters of its own, for tests", .formula = "none",
              .source = "none", .validity = "tests")
