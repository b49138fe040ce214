#pragma once

#include <stylet/parameters.h>

namespace stylet::rod {

inline constexpr Parameter parameters[] = {
    finer_above(integer("nodes", {.least = 5, .greatest = 1001}, "nodes from the base to the tip, evenly spaced")),
    number("density", "kg/m^3", positive, "mass density of the needle"),
    number("poisson_ratio", "1", {.least = -1.0, .greatest = 0.5, .open_below = true, .open_above = true},
           "Poisson's ratio of the needle, for its twisting"),
    number("imperfection", "m", positive,
           "height of the stress-free needle's bow, a (1 - cos(2 pi s/L))/2: from which side it buckles, and how sharply"),
    optional(
        number("natural_curvature", "1/m", any,
               "curvature of the stress-free needle, toward the side to which it bows, away from the line that its base points "
               "along; left out: straight")),
    optional(
        number("bevel_cut_angle", "rad", {.least = 0.0, .greatest = 0.17453292519943295, .open_below = true},
               "by which a bevelled tip cuts aside of its axis, toward the side to which the needle bows, as measured for this "
               "bevel and tissue: sharper ones cut further aside; further aside than ten degrees no track would hold the tip; "
               "left out: it cuts straight on")),
    optional(number("damping_time", "s", positive,
                    "retardation time of Kelvin-Voigt damping in bending and twisting; left out: no damping")),
};

}    // namespace stylet::rod
