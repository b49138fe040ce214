#include "core/run/sample.h"
#include "core/scene/plugin_choice.h"
#include "core/scene/sections.h"
#include "core/scene/suggestion.h"

#include <stylet/body.h>

#include <fmt/format.h>

#include <algorithm>

namespace stylet::core {

constexpr double most_ticks = 1e9;    // eleven days at 1 kHz

void read_effects(const ValueTree& list, Reading& reading, Scene& scene) {
    if (list.shape != ValueTree::Shape::list) {
        reading.complaints.add(list.place, "effects",
                               fmt::format("found {}, wanted a list of maps ({})", list.description(), effects_section.meaning));
        return;
    }
    for (std::size_t i = 0; i < list.items.size(); ++i) {
        const std::string path = join("effects", i);
        if (!is_map(list.items[i], path, "an effect that acts", reading)) continue;
        scene.effects.push_back(read_choice(list.items[i], path, effects_section, reading));
    }
}

void read_device(const ValueTree& map, Reading& reading, Scene& scene) {
    scene.device = read_choice(map, "device", device_section, reading);
    const Parameters keys = read_parameters(map, "device", device_keys, reading);
    if (keys.has("force_limit")) scene.force_limit = keys.number("force_limit");
}

void read_coupling(const ValueTree& map, Reading& reading, Scene& scene) {
    const Parameters keys = read_parameters(map, "coupling", coupling_keys, reading);
    refuse_unknown_keys(map, "coupling", names_of(coupling_keys), reading);
    scene.contact_spacing = number_or_nan(keys, "contact_spacing");
    if (!scene.needle_setup) return;
    const double closest = scene.needle_setup->length / (max_contacts - 1);    // the needle is read before
    if (scene.contact_spacing < closest) {
        reading.complaints.add(reading.places.at("coupling.contact_spacing"), "coupling.contact_spacing",
                               fmt::format("found {}, wanted at least {:g} m (the needle has room for {} contacts)",
                                           map.find("contact_spacing")->description(), closest, max_contacts - 1));
    }
}

void read_run(const ValueTree& map, Reading& reading, Scene& scene) {
    const Parameters keys = read_parameters(map, "run", run_keys, reading);
    refuse_unknown_keys(map, "run", names_of(run_keys), reading);
    scene.run.rate = number_or_nan(keys, "rate");
    if (!keys.has("duration")) return;
    scene.run.duration = keys.number("duration");
    if (const double ticks = *scene.run.duration * scene.run.rate; ticks > most_ticks) {
        reading.complaints.add(reading.places.at("run.duration"), "run.duration",
                               fmt::format("found {}, wanted at most {:g} s at this rate (how long the run is)",
                                           map.find("duration")->description(), most_ticks * scene.run.dt()));
    } else if (ticks < 0.5) {
        reading.complaints.add(reading.places.at("run.duration"), "run.duration",
                               fmt::format("found {}, wanted at least one tick of {:g} s (how long the run is)",
                                           map.find("duration")->description(), scene.run.dt()));
    }
}

namespace {

const Column* column_of_an_absent_part(const std::string& word, const Scene& scene) {
    const auto named = std::ranges::find_if(all_columns(), [&](const Column& column) { return word == column.name; });
    return named == all_columns().end() || there(*named, scene.needle.has_value(), scene.tissue.has_value()) ? nullptr : &*named;
}

}    // namespace

void read_record(const ValueTree& list, Reading& reading, Scene& scene) {
    if (list.shape != ValueTree::Shape::list || list.items.empty()) {
        reading.complaints.add(list.place, "record",
                               fmt::format("found {}, wanted a list ({})", list.description(), record_section.meaning));
        return;
    }
    const std::vector<std::string> words = record_words();
    for (std::size_t i = 0; i < list.items.size(); ++i) {
        const ValueTree& item = list.items[i];
        const bool known = item.shape == ValueTree::Shape::scalar && std::ranges::find(words, item.text) != words.end();
        if (const Column* absent = known && !reading.complaints.any() ? column_of_an_absent_part(item.text, scene) : nullptr) {
            const char* part = scene.needle ? "tissue" : absent->of == Column::Of::tissue ? "tissue" : "needle";
            reading.complaints.add(
                item.place, join("record", i),
                fmt::format("found {}, and the scene has no {} (columns to record)", item.description(), part));
        } else if (known) {
            scene.record.push_back(item.text);
        } else {
            reading.complaints.add(
                item.place, join("record", i),
                "found " + item.description() + ", wanted one of " + list_of(words) + suggestion(item.text, words));
        }
    }
}

}    // namespace stylet::core
