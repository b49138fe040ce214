#include "core/scene/gauges.h"
#include "core/scene/plugin_choice.h"
#include "core/scene/sections.h"

#include <fmt/format.h>

#include <algorithm>

namespace stylet::core {
namespace {

Ends ends_of(const std::string& word) {
    if (word == "clamped-free") return Ends::clamped_free;
    if (word == "pinned-pinned") return Ends::pinned_pinned;
    if (word == "clamped-pinned") return Ends::clamped_pinned;
    return Ends::clamped_clamped;
}

/// Complains of `key`, which the map gives.
void complain_of(const char* key, const ValueTree& map, const std::string& wanted, Reading& reading) {
    const std::string path = join("needle", key);
    const std::string sentence = fmt::format("found {}, wanted {}", map.find(key)->description(), wanted);
    reading.complaints.add(reading.places.at(path), path, sentence);
}

/// A gauge says both radii.
void read_gauge(const ValueTree& map, const Parameters& keys, NeedleSetup& needle, Reading& reading) {
    if (keys.has("gauge")) {
        const Gauge& gauge = *find_gauge(keys.text("gauge"));    // one of its declared choices
        needle.radius = gauge.outer_diameter / 2.0;
        needle.inner_radius = gauge.inner_diameter / 2.0;
    }
    for (const char* key : {"radius", "inner_radius"}) {
        if (map.find(key) == nullptr) continue;
        complain_of(key, map,
                    fmt::format("none beside gauge {}, which says it already: change needle.gauge, or give radii instead of it",
                                map.find("gauge")->description()),
                    reading);
    }
    if (needle.radius >= needle.length) {
        complain_of(
            "gauge", map,
            fmt::format("a radius less than the needle's length of {:g} m (this one's is {:g} m)", needle.length, needle.radius),
            reading);
    }
}

void read_radii(const ValueTree& map, const Parameters& keys, NeedleSetup& needle, Reading& reading) {
    constexpr double thinnest_wall = 1e-6;    // of the radius: a thinner one is lost to rounding, and with it all stiffness
    if (map.find("radius") == nullptr) {
        miss_key(map, "needle.radius", "a length in m such as '0.3 mm' (needle radius), or a gauge such as 22G", reading);
    }
    needle.radius = number_or_nan(keys, "radius");
    if (keys.has("inner_radius")) needle.inner_radius = keys.number("inner_radius");
    if (needle.radius >= needle.length) {
        complain_of("radius", map, fmt::format("less than the needle's length of {:g} m (needle radius)", needle.length),
                    reading);
    }
    if (needle.inner_radius > needle.radius * (1.0 - thinnest_wall)) {
        complain_of("inner_radius", map,
                    fmt::format("less than the needle's radius of {:g} m (inner radius of a tube)", needle.radius), reading);
    }
}

/// Whoever gives one of two ways to say how thick the needle is on top of a scene means it instead of the scene's.
ValueTree with_one_thickness(const ValueTree& map) {
    const auto given = [](const ValueTree::Entry& entry) { return entry.value.place.line == 0; };
    const auto gauge = [](const ValueTree::Entry& entry) { return entry.key == "gauge"; };
    const auto radii = [](const ValueTree::Entry& entry) { return entry.key == "radius" || entry.key == "inner_radius"; };
    const auto any = [&](const auto& kind) {
        return std::ranges::any_of(map.entries, [&](const auto& entry) { return kind(entry) && given(entry); });
    };
    const bool new_gauge = any(gauge), new_radii = any(radii);
    ValueTree one = map;
    std::erase_if(one.entries, [&](const ValueTree::Entry& entry) {
        return !given(entry) && ((new_gauge && radii(entry)) || (new_radii && gauge(entry)));
    });
    return one;
}

}    // namespace

void read_needle(const ValueTree& section, Reading& reading, Scene& scene) {
    const ValueTree map = with_one_thickness(section);
    scene.needle = read_choice(map, "needle", needle_section, reading);
    const Parameters keys = read_parameters(map, "needle", needle_keys, reading);
    NeedleSetup& needle = scene.needle_setup.emplace();
    needle.length = number_or_nan(keys, "length");
    needle.youngs_modulus = number_or_nan(keys, "youngs_modulus");
    if (keys.has("ends")) needle.ends = ends_of(keys.text("ends"));
    if (keys.has("gauge")) scene.gauge = keys.text("gauge");
    if (map.find("gauge") != nullptr) {
        read_gauge(map, keys, needle, reading);
    } else {
        read_radii(map, keys, needle, reading);
    }
    const ValueTree* buckling = map.find("buckling");
    if (buckling != nullptr && is_map(*buckling, "needle.buckling", buckling_section.meaning, reading)) {
        scene.buckling = read_choice(*buckling, "needle.buckling", buckling_section, reading);
    }
}

}    // namespace stylet::core
