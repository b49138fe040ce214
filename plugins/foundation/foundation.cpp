#include "foundation.h"

namespace stylet::foundation {
namespace {

using std::numbers::pi;

/// ∫ (1 − cos(πξ/2))² dξ from 0 to `fraction`.
double squared_deflection(double fraction) {
    return 1.5 * fraction - 4.0 / pi * std::sin(0.5 * pi * fraction) + 0.5 / pi * std::sin(pi * fraction);
}

}    // namespace

FoundationFormula::FoundationFormula(const Setup& setup)
    : foundation_(setup),
      form_(setup.parameters.text("form") == "printed" ? FoundationForm::printed : FoundationForm::consistent) {
    if (setup.needle != nullptr && setup.needle->ends != Ends::clamped_free)
        throw Error("needle.ends",
                    "found other ends than clamped-free, wanted `ends: clamped-free`: Eq. (2) is of such a column "
                    "(winkler takes any ends)");
}

double FoundationFormula::critical_load(const Column& column) const {
    const double length = std::max(column.length(), column.radius);
    const FoundationPieces pieces = foundation_.under(column);
    const double at_tip = pieces.size() == 0 ? 0.0 : pieces[pieces.size() - 1].modulus;    // [Pa]
    const double share = 1.0 - squared_deflection(std::min(column.free_length / length, 1.0)) / squared_deflection(1.0);
    return foundation_load(column.bending_stiffness, length, share * at_tip, form_);
}

namespace {

constexpr Parameter parameters[] = {
    choice(
        "form", "printed consistent",
        "Eq. (2) as it is printed, or with the effective length 2l in both terms, which the paper's tables were calculated with"),
    foundation_modulus_parameter,
    given_moduli_parameter,
};

}    // namespace
}    // namespace stylet::foundation

STYLET_PLUGIN(
    stylet::foundation::FoundationFormula, "foundation", stylet::foundation::parameters,
    .summary = "The critical load of a clamped-free needle in homogeneous tissue, as the paper has it",
    .formula =
        "printed:     P = pi^2 EI/(4 l^2) + s mu l^2/pi^2\n"
        "consistent:  P = pi^2 EI/(2 l)^2 + s mu (2 l)^2/pi^2\n"
        "P [N] critical load, EI [N m^2] bending stiffness, l [m] base to tip, mu [Pa] foundation modulus of the tip's layer\n"
        "s: share of the part in tissue in the integral of w^2, w = 1 - cos(pi x/2l); 1 all in tissue, 0 all in air",
    .source =
        "He, Chen and Tang, Eq. (2). Its printed form lacks a factor 4 that their Tables 1 and 2 were calculated with. "
        "Deviations: "
        "s, which Eq. (2) does not have, keeps the load continuous while the needle goes in; of layers, the tip's alone counts; "
        "a "
        "length below the needle's radius counts as the radius",
    .validity =
        "Needles clamped at the base and free at the tip, for a mu that was fitted to this length by their Eq. (3): for one "
        "tissue "
        "it changes 13-fold from 20 to 120 mm. The load jumps where the tip enters another layer. Leaves out all other layers, "
        "and "
        "everything that Euler's load leaves out")
