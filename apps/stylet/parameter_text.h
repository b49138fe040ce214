// A plugin's parameters as documentation, from the declarations that also read and check them.
#pragma once

#include <stylet/plugin.h>

#include <nlohmann/json.hpp>

#include <span>
#include <string>

namespace stylet::app {

using ParameterList = std::span<const Parameter>;

[[nodiscard]] inline ParameterList parameters_of(const Descriptor& plugin) {
    return {plugin.parameters, plugin.parameter_count};
}
[[nodiscard]] inline ParameterList fields_of(const Parameter& parameter) {
    return {parameter.fields, parameter.field_count};
}

/// A line for each parameter, its meaning below it; the fields of records further in.
[[nodiscard]] std::string parameters_text(ParameterList parameters);

[[nodiscard]] nlohmann::ordered_json parameters_json(ParameterList parameters);

}    // namespace stylet::app
