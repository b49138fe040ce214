#include "core/scene/plugin_choice.h"
#include "core/scene/sections.h"

#include <fmt/format.h>

#include <cmath>
#include <set>

namespace stylet::core {
namespace {

Layer layer_of(const Parameters& keys) {
    return {.name = keys.has("name") ? keys.text("name") : "",
            .youngs_modulus = number_or_nan(keys, "youngs_modulus"),
            .poisson_ratio = number_or_nan(keys, "poisson_ratio"),
            .density = number_or_nan(keys, "density"),
            .thickness = number_or_nan(keys, "thickness")};
}

void refuse_equal_names(const std::vector<Layer>& layers, Reading& reading) {
    std::set<std::string> seen;
    for (std::size_t i = 0; i < layers.size(); ++i) {
        if (layers[i].name.empty() || seen.insert(layers[i].name).second) continue;
        const std::string path = join(join("tissue.layers", i), "name");
        reading.complaints.add(
            reading.places.at(path), path,
            fmt::format("found {} a second time, wanted a name of its own for each layer", quote(layers[i].name)));
    }
}

/// Complains of a layer above the last that gives no thickness; true where all of them give one.
bool all_but_last_are_thick(const Parameters::Records& records, Reading& reading) {
    bool all = true;
    for (std::size_t i = 0; i + 1 < records.size(); ++i) {
        if (records[i].has("thickness")) continue;
        all = false;
        const std::string layer = join("tissue.layers", i);
        const std::string path = join(layer, "thickness");
        if (reading.places.contains(path)) continue;    // given, and already complained of
        reading.complaints.add(
            reading.places.at(layer), path,
            "found nothing, wanted a length in m such as '25 mm' (only the last layer may leave its thickness out)");
    }
    return all;
}

/// Stacks the layers from the surface down; the last one reaches the bottom.
void stack(std::vector<Layer>& layers, double height, Reading& reading) {
    constexpr double rounding = 1e-9;    // of the height: sums of lengths that were written in decimals
    double above = 0.0;
    for (std::size_t i = 0; i + 1 < layers.size(); ++i) above += layers[i].thickness;
    Layer& last = layers.back();
    const Place& place = reading.places.at("tissue.layers");
    if (above >= height * (1.0 - rounding)) {
        reading.complaints.add(
            place, "tissue.layers",
            fmt::format("found {:g} m of layers above the last, wanted less than the tissue's height of {:g} m", above, height));
    } else if (std::abs(above + last.thickness - height) > rounding * height) {    // not of a NaN: left out
        reading.complaints.add(
            place, "tissue.layers",
            fmt::format("found layers of {:g} m together, wanted the tissue's height of {:g} m (the last layer may "
                        "leave its thickness out and then reaches the bottom)",
                        above + last.thickness, height));
    }
    last.thickness = height - above;
}

}    // namespace

void read_tissue(const ValueTree& map, Reading& reading, Scene& scene) {
    scene.tissue = read_choice(map, "tissue", tissue_section, reading);
    const Parameters keys = read_parameters(map, "tissue", tissue_keys, reading);
    TissueSetup& tissue = scene.tissue_setup.emplace();
    if (keys.has("extent")) tissue.extent = keys.vector3("extent");
    if (keys.has("fixed")) tissue.fixed = keys.text("fixed");
    if (!keys.has("layers")) return;
    const Parameters::Records& records = keys.records("layers");
    for (const Parameters& record : records) tissue.layers.push_back(layer_of(record));
    refuse_equal_names(tissue.layers, reading);
    if (all_but_last_are_thick(records, reading) && keys.has("extent")) stack(tissue.layers, tissue.extent.z(), reading);
}

}    // namespace stylet::core
