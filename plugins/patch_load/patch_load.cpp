#include "patch_load.h"

#include <sstream>

namespace stylet::patch_load {

PatchLoad::PatchLoad(const Setup& setup)
    : patch_{.centre = setup.parameters.vector3("centre"), .size = setup.parameters.vector3("size")},
      force_(setup.parameters.vector3("force")),
      ramp_(setup.parameters) {
    if (setup.tissue == nullptr) throw Error("found a scene without a tissue, wanted one whose surface this can load");
    if ((patch_.size.array() >= 0.0).all()) return;
    std::ostringstream message;
    message << "found a side of " << patch_.size.minCoeff() << " m, wanted none below zero";
    throw Error("size", message.str());
}

namespace {

constexpr Parameter parameters[] = {
    vector3("centre", "m", "of the box whose part of the tissue's undeformed surface is loaded"),
    vector3("size", "m", "of this box along x, y and z; a side of no length is a plane"),
    vector3("force", "N", "on the whole patch, shared evenly, in world coordinates"),
    ramp_parameter,
};

}    // namespace
}    // namespace stylet::patch_load

STYLET_PLUGIN(stylet::patch_load::PatchLoad, "patch_load", stylet::patch_load::parameters,
              .summary = "A prescribed force on a patch of the tissue's surface",
              .formula = "F(t) = s(t) F, s = 1 from time 0 on, or min(t/ramp, 1)",
              .source = "Love 1929 for a rectangle; the constant traction of a static test",
              .validity = "As far as the tissue's model. A dead load: neither its direction nor the patch follows the surface")
