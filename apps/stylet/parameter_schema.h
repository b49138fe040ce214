// The JSON Schema of declared parameters.
#pragma once

#include "apps/stylet/kinds.h"

#include <nlohmann/json.hpp>

#include <string>

namespace stylet::app {

/// Of a map that holds these and nothing else. `origin` ends each description: which plugin declares them, after which source.
[[nodiscard]] nlohmann::ordered_json map_schema(ParameterList parameters, const std::string& origin = "");

}    // namespace stylet::app
