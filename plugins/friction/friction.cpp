#include "friction.h"

#include <stylet/layers.h>

#include <sstream>

namespace stylet::friction {

Friction::Friction(const Setup& setup)
    : kinetic_(setup.parameters.number("per_length")), static_(kinetic_), layer_(chosen_layer(setup)) {
    expect_needle_and_tissue(setup);
    if (!setup.parameters.has("static_per_length")) return;
    static_ = setup.parameters.number("static_per_length");
    if (static_ >= kinetic_) return;
    std::ostringstream message;
    message << "found " << static_ << " N/m, wanted at least per_length, which is " << kinetic_
            << " N/m: what sticks holds no less than what slips";
    throw Error("static_per_length", message.str());
}

void Friction::add_to(const Contact& contact, ContactLaw& law) const {
    if (contact.tip || (layer_ && *layer_ != contact.layer)) return;
    law.add_axial(contact.coverage * (contact.slipping ? kinetic_ : static_));
}

namespace {

constexpr Parameter parameters[] = {
    number("per_length", "N/m", not_negative, "friction per covered length of shaft while it slips"),
    optional(number("static_per_length", "N/m", not_negative,
                    "friction per covered length up to which it sticks, at least per_length; left out: the same as per_length")),
    optional(text("layer", "acts only in the layer of this name; left out: in every layer")),
};

}    // namespace
}    // namespace stylet::friction

STYLET_PLUGIN(stylet::friction::Friction, "friction", stylet::friction::parameters,
              .summary = "Dry friction along the shaft, per covered length",
              .formula =
                  "|f| <= f_s c while a contact sticks\n"
                  "|f|  = f_k c while it slips\n"
                  "c [m] shaft that the contact covers, f_k [N/m] per_length, f_s [N/m] static_per_length",
              .source =
                  "Okamura, Simone and O'Leary 2004, the static and dynamic Coulomb terms of their modified Karnopp model. "
                  "Deviation: no viscous part, and the coupling's forces decide what sticks, not a band of velocities",
              .validity =
                  "Where the tissue's grip on the shaft depends neither on depth nor on speed. Leaves out the tip, the gradual "
                  "build-up before slip (Dahl) and any change of grip with the tissue's pressure")
