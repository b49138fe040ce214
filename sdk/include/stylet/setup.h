// What core hands a plugin when it makes it: the plugin's own parameters and the parts of the scene that every role may know.
#pragma once

#include <stylet/parameters.h>
#include <stylet/workers.h>

#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

namespace stylet {

class BucklingModel;

/// How the two ends of a needle's free length are held: base first, then the end at the tissue.
enum class Ends : std::uint8_t { clamped_free, pinned_pinned, clamped_pinned, clamped_clamped };

/// One layer of tissue; layers are stacked from the surface down.
struct Layer {
    std::string name;
    double youngs_modulus;    // [Pa]
    double poisson_ratio;     // in (−1, 0.5)
    double density;           // [kg/m³], NaN where the scene gives none
    double thickness;         // [m]; the last layer reaches the bottom
};

/// The common keys of every tissue.
struct TissueSetup {
    Vector3 extent;               // [m] block size in x, y, z; centred on the origin, top at z = 0
    std::string fixed;            // "bottom", "sides" or "bottom_and_sides"
    std::vector<Layer> layers;    // from the top
};

/// The common keys of every needle.
struct NeedleSetup {
    double length;                // [m] from the base to the tip
    double radius;                // [m]
    double inner_radius = 0.0;    // [m] of a tube; zero: a solid section
    double youngs_modulus;        // [Pa]
    Ends ends;

    [[nodiscard]] double area() const {    // [m²] of the section
        return std::numbers::pi * (radius * radius - inner_radius * inner_radius);
    }
    [[nodiscard]] double second_moment() const {    // [m⁴] I of the section about a diameter
        const double outer = radius * radius, inner = inner_radius * inner_radius;
        return std::numbers::pi * (outer * outer - inner * inner) / 4.0;
    }
    [[nodiscard]] double bending_stiffness() const { return youngs_modulus * second_moment(); }    // [N·m²] EI
};

/// Everything a plugin is made from. References and pointers hold while the plugin lives.
struct Setup {
    const Parameters& parameters;     // the plugin's own
    const TissueSetup* tissue;        // nullptr where the scene has none; a tissue is always given its own
    const NeedleSetup* needle;        // nullptr where the scene has none; a needle is always given its own
    const BucklingModel* buckling;    // for a needle: nullptr where the scene names none
    double dt;                        // [s] the scene's time step
    Workers& workers;                 // threads that core lends; a plugin makes none of its own
};

}    // namespace stylet
