// The keys that are core's own: accepted for every plugin of a role, declared as a plugin declares its parameters.
#pragma once

#include "core/scene/gauges.h"

#include <stylet/parameters.h>

namespace stylet::core {

/// The scene format that this program reads.
inline constexpr int format_version = 1;

/// Bounds each component.
constexpr Parameter within(Range range, Parameter parameter) {
    parameter.range = range;
    return parameter;
}

inline constexpr Parameter layer_keys[] = {
    text("name", "what events and summaries call the layer"),
    number("youngs_modulus", "Pa", positive, "Young's modulus of the layer"),
    number("poisson_ratio", "1", {.least = -1.0, .greatest = 0.5, .open_below = true, .open_above = true},
           "Poisson's ratio of the layer"),
    optional(number("density", "kg/m^3", positive, "mass density of the layer; only a tissue with inertia asks for it")),
    optional(number("thickness", "m", positive,
                    "thickness of the layer; the last layer may leave it out and then reaches the bottom")),
};

inline constexpr Parameter tissue_keys[] = {
    within(positive, vector3("extent", "m", "size of the tissue block, its top centred on the origin")),
    choice("fixed", "bottom sides bottom_and_sides", "faces of the block that are held"),
    records("layers", layer_keys, "layers of the tissue, from the surface down"),
};

inline constexpr Parameter needle_keys[] = {
    number("length", "m", positive, "needle length from the base to the tip"),
    optional(choice("gauge", gauge_names, "a hypodermic needle of regular wall; either this or `radius`")),
    optional(number("radius", "m", positive, "needle radius; either this or `gauge`")),
    optional(number("inner_radius", "m", positive, "inner radius of a tube, beside `radius`; left out, the needle is solid")),
    number("youngs_modulus", "Pa", positive, "Young's modulus of the needle"),
    choice("ends", "clamped-free pinned-pinned clamped-pinned clamped-clamped",
           "how the free length is held: the base, then the end at the tissue"),
};

inline constexpr Parameter device_keys[] = {
    optional(number("force_limit", "N", positive, "largest force at the hand; the lower of this and the device's own counts")),
};

inline constexpr Parameter coupling_keys[] = {
    finer_below(number("contact_spacing", "m", positive, "length of track between two contacts along the shaft")),
};

inline constexpr Parameter run_keys[] = {
    finer_above(number("rate", "Hz", {.least = 0.1, .greatest = 1e5}, "ticks per second of simulated time")),
    optional(number("duration", "s", positive, "simulated time; left out, the run lasts as long as the device's motion")),
};

inline constexpr Parameter scene_keys[] = {
    text("title", "one line for lists of scenes"),
};

}    // namespace stylet::core
