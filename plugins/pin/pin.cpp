#include "pin.h"

#include <stylet/tissue_model.h>

namespace stylet::pin {

Pin::Pin(const Setup& setup) {
    if (setup.tissue != nullptr)
        throw Error("found a scene with a tissue, wanted a needle alone: this holds a tip that is in air");
    if (setup.needle == nullptr) throw Error("found a scene without a needle, wanted one whose tip this can hold");
    if (setup.needle->ends == Ends::clamped_free)
        throw Error("needle.ends", "found clamped-free, wanted ends whose tip is held: the scene pins it");
}

void Pin::add_to(const Contact& contact, ContactLaw& law) const {
    if (contact.tip && contact.layer == outside) law.held = true;
}

}    // namespace stylet::pin

STYLET_PLUGIN(stylet::pin::Pin, "pin", stylet::no_parameters,
              .summary = "A rigid stop that holds the tip of a needle alone in air", .formula = "u_tip = 0",
              .source = "Timoshenko and Gere 1961, section 2.1, the supports of a column",
              .validity = "Needles whose ends are not clamped-free. Leaves out any give of the stop")
