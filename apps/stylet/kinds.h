// What the kinds of parameters are called.
#pragma once

#include <stylet/plugin.h>

#include <span>
#include <string>
#include <vector>

namespace stylet::app {

using ParameterList = std::span<const Parameter>;

[[nodiscard]] inline ParameterList parameters_of(const Descriptor& plugin) {
    return {plugin.parameters, plugin.parameter_count};
}
[[nodiscard]] inline ParameterList fields_of(const Parameter& parameter) {
    return {parameter.fields, parameter.field_count};
}

[[nodiscard]] const char* name_of(Kind kind);
[[nodiscard]] bool is_numeric(Kind kind);
[[nodiscard]] std::vector<std::string> words_of(const char* text);

}    // namespace stylet::app
