#include "core/scene/plugin_choice.h"
#include "core/scene/sections.h"

#include <fmt/format.h>

namespace stylet::core {
namespace {

Ends ends_of(const std::string& word) {
    if (word == "clamped-free") return Ends::clamped_free;
    if (word == "pinned-pinned") return Ends::pinned_pinned;
    if (word == "clamped-pinned") return Ends::clamped_pinned;
    return Ends::clamped_clamped;
}

}    // namespace

void read_needle(const ValueTree& map, Reading& reading, Scene& scene) {
    scene.needle = read_choice(map, "needle", needle_section, reading);
    const Parameters keys = read_parameters(map, "needle", needle_keys, reading);
    NeedleSetup& needle = scene.needle_setup.emplace();
    needle.length = number_or_nan(keys, "length");
    needle.radius = number_or_nan(keys, "radius");
    needle.youngs_modulus = number_or_nan(keys, "youngs_modulus");
    if (keys.has("ends")) needle.ends = ends_of(keys.text("ends"));
    if (needle.radius >= needle.length) {
        reading.complaints.add(reading.places.at("needle.radius"), "needle.radius",
                               fmt::format("found {}, wanted less than the needle's length of {:g} m (needle radius)",
                                           map.find("radius")->description(), needle.length));
    }
    const ValueTree* buckling = map.find("buckling");
    if (buckling != nullptr && is_map(*buckling, "needle.buckling", buckling_section.meaning, reading)) {
        scene.buckling = read_choice(*buckling, "needle.buckling", buckling_section, reading);
    }
}

}    // namespace stylet::core
