#include "end_load.h"

#include <stylet/tissue_model.h>

namespace stylet::end_load {

EndLoad::EndLoad(const Setup& setup) : force_(setup.parameters.vector3("force")), ramp_(setup.parameters) {
    if (setup.tissue != nullptr)
        throw Error("found a scene with a tissue, wanted a needle alone: this loads a tip that is in air");
    if (setup.needle == nullptr) throw Error("found a scene without a needle, wanted one whose tip this can load");
}

void EndLoad::add_to(const Contact& contact, ContactLaw& law) const {
    if (contact.tip && contact.layer == outside) law.own_force += ramp_.share(contact.time) * force_;
}

namespace {

constexpr Parameter parameters[] = {
    vector3("force", "N", "on the tip, in world coordinates; a needle without a device points to −z, so that +z compresses it"),
    ramp_parameter,
};

}    // namespace
}    // namespace stylet::end_load

STYLET_PLUGIN(stylet::end_load::EndLoad, "end_load", stylet::end_load::parameters,
              .summary = "A prescribed force on the tip of a needle alone in air",
              .formula = "F(t) = s(t) F, s = 1 from time 0 on, or min(t/ramp, 1)",
              .source = "Euler 1757, a column under an end load",
              .validity = "As far as the needle's model. A dead load: its direction doesn't follow the tip")
