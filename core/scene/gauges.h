// Hypodermic needles by their gauge.
#pragma once

#include <span>
#include <string_view>

namespace stylet::core {

struct Gauge {
    const char* name;         // "22G"
    double outer_diameter;    // [m]
    double inner_diameter;    // [m]
};

/// From the thickest to the thinnest: nominal diameters of needles of regular wall.
/// Source: the Birmingham (Stubs) needle gauge comparison chart, 7G to 34G, as makers of needles print it. Ordinary needles only:
/// thin-walled ones have a wider bore, 22s and 26s a narrower one. A scene gives such a needle its radii instead.
[[nodiscard]] std::span<const Gauge> gauges();

/// The gauge of this name; nullptr where there is none.
[[nodiscard]] const Gauge* find_gauge(std::string_view name);

/// The names of all, separated by blanks.
extern const char gauge_names[];

}    // namespace stylet::core
