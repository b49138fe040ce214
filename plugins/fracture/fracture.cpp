#include "fracture.h"

#include <stylet/layers.h>

#include <numbers>

namespace stylet::fracture {

Fracture::Fracture(const Setup& setup)
    : rupture_force_(setup.parameters.number("rupture_force")),
      toughness_(setup.parameters.number("toughness")),
      layer_(chosen_layer(setup)) {
    expect_needle_and_tissue(setup);
}

double Fracture::cutting_force(double needle_radius) const {
    return 2.0 * std::numbers::pi * needle_radius * toughness_;
}

void Fracture::add_to(const Contact& contact, ContactLaw& law) const {
    if (!contact.tip || !acts_in(contact.layer)) return;
    law.add_tip(contact.inside ? cutting_force(contact.needle_radius) : rupture_force_);
}

double Fracture::settle(const Settlement& change) {
    return acts_in(change.layer) ? cutting_force(change.needle_radius) * change.cut : 0.0;
}

namespace {

constexpr Parameter parameters[] = {
    number("rupture_force", "N", positive, "force on the tip at which the surface ruptures"),
    number("toughness", "J/m^2", not_negative, "fracture energy J_c per area of crack; the tip cuts at 2 pi r J_c"),
    optional(
        text("layer",
             "acts only in the layer of this name; left out: in every layer. A tip stops at a layer in which no fracture acts")),
};

}    // namespace
}    // namespace stylet::fracture

STYLET_PLUGIN(
    stylet::fracture::Fracture, "fracture", stylet::fracture::parameters,
    .summary = "Rupture of the surface, then fracture energy for every length cut",
    .formula =
        "outside: tip force <= F_r, and at F_r the surface ruptures\n"
        "inside:  tip force <= 2 pi r J_c, and at 2 pi r J_c the tip cuts\n"
        "a cut of length l costs the energy 2 pi r J_c l\n"
        "F_r [N] rupture_force, J_c [J/m^2] toughness, r [m] needle radius",
    .source =
        "He, Chen and Tang, section III, the fracture term of Eq. (7); Gokgol, Basdogan and Canadinc 2012 for J_c = 164 J/m^2 "
        "of bovine liver. Deviation: the energy enters as the limit of the tip's force, and the ledger closes the balance",
    .validity =
        "A sharp tip whose crack is as long as the needle's circumference. Leaves out rate dependence, the shape of the tip, "
        "and a rupture force of the layers below the surface")
