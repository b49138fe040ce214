#include "elastica.h"

#include <numbers>

namespace stylet::elastica {

Elastica::Elastica(const Setup& setup)
    : ColumnNeedle(setup, ElasticaCurve::of(setup.needle->ends)),
      curve_(ElasticaCurve::of(setup.needle->ends)),
      over_tissue_(setup.tissue != nullptr) {}

const char* Elastica::beyond_validity() const {
    const double shortening = committed_shortening();
    if (shortening >= curve_.folded()) return "beyond validity: the needle is folded up";
    if (shortening >= curve_.touches_itself()) return "beyond validity: the needle's bow meets itself";
    if (over_tissue_ && curve_.largest_slope(shortening) > 0.5 * std::numbers::pi) {
        return "beyond validity: the needle's slope is over 90°, its bow would lie on the tissue";
    }
    return nullptr;
}

}    // namespace stylet::elastica

STYLET_PLUGIN(
    stylet::elastica::Elastica, "elastica", stylet::no_parameters,
    .summary = "An exact column: straight up to its critical load, then the elastica of its ends, with its limit load",
    .formula =
        "straight: d = 0, N <= P_cr(L)\n"
        "bowed:    d > 0, N = P_cr(L) f(d/L)\n"
        "stored:   U = P_cr(L) L (integral of f from 0 to d/L), the bending energy of the bow\n"
        "f = (2K/pi)^2 at d/L = 2 - 2E/K for clamped-free, pinned-pinned and clamped-clamped ends; for clamped-pinned ones the "
        "arc\n"
        "of the inflectional elastica from an inflection at the pin to the clamp with both on one line\n"
        "d [m] shortening of the free length L [m], N [N] compression, K and E complete elliptic integrals; P_cr [N] from\n"
        "`buckling`, or without one k EI/L^2, k = pi^2/4, pi^2, 4.4934^2, 4 pi^2 for the four ends",
    .source =
        "Euler 1744; Love 1927, A Treatise on the Mathematical Theory of Elasticity, sections 262 and 263; Timoshenko and Gere "
        "1961, section 2.7; Bigoni et al. 2015 for the force at the mouth of the track. Deviation: tables of 1000 cubic pieces, "
        "within 1e-9",
    .validity =
        "Inextensible, elastic, in one plane. Clamped-pinned ends carry at most 1.1396 P_cr, at d = 0.454 L; beyond that the "
        "load "
        "falls, to next to nothing at d = 0.812 L, where it stops; other ends stop where they are level, d = L. Named when "
        "passed: a "
        "slope "
        "over 90 degrees where there is tissue, a bow that meets itself (clamped-clamped, d = 0.849 L), the stop. A free tip "
        "(clamped-free) goes "
        "aside in the shape that is drawn alone; its contacts stay on the needle's line. Leaves out yielding, bending by lateral "
        "forces, bowing out of the plane, and inertia: a snap is booked as numerical loss")
