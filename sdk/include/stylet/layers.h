#pragma once

#include <stylet/setup.h>

#include <optional>

namespace stylet {

/// The layer that a plugin's optional text parameter `layer` names: its index from the top, or nothing where the scene leaves it
/// out. Throws Error at `layer` where the tissue has no layer of this name, or where there is no tissue.
[[nodiscard]] inline std::optional<int> chosen_layer(const Setup& setup) {
    if (!setup.parameters.has("layer")) return std::nullopt;
    const std::string& wanted = setup.parameters.text("layer");
    if (setup.tissue == nullptr) throw Error("layer", "found \"" + wanted + "\", and the scene has no tissue with layers");
    std::string names;
    for (std::size_t i = 0; i < setup.tissue->layers.size(); ++i) {
        const std::string& name = setup.tissue->layers[i].name;
        if (name == wanted) return static_cast<int>(i);
        names += (i == 0 ? "" : ", ") + name;
    }
    throw Error("layer", "found \"" + wanted + "\", wanted the name of one of the tissue's layers: " + names);
}

}    // namespace stylet
