// Which models of the critical load are asked, and with which parameters.
#pragma once

#include "core/scene/reader.h"

#include <string>
#include <vector>

namespace stylet::app {

/// A model as `--model` names it: foundation,form=printed.
struct AskedModel {
    std::string type;
    std::vector<std::string> changes;         // of its parameters, each KEY=VALUE
    std::vector<core::Override> overrides;    // that put it and them into a scene

    /// "foundation form=printed"
    [[nodiscard]] std::string label() const;
};

/// Throws Failure where the text is no NAME[,KEY=VALUE]… at all; what the names and values are worth a scene's reader tells.
[[nodiscard]] AskedModel read_asked_model(const std::string& text);

/// The scene's own model, and every other that its section holds a map for; none where it has no such section.
[[nodiscard]] std::vector<AskedModel> models_of(const core::Scene& scene);

}    // namespace stylet::app
