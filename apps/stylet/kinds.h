// What lists, pages and editors are told of a declared parameter.
#pragma once

#include <stylet/plugin.h>

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

[[nodiscard]] const char* name_of(Kind kind);
[[nodiscard]] bool has_range(Kind kind);

/// Its numbers carry a unit.
[[nodiscard]] bool has_dimension(const Parameter& parameter);

/// "number (N/m)"
[[nodiscard]] std::string kind_text(const Parameter& parameter);
/// "≥ 0", "any", "bottom | sides"; empty where there is none.
[[nodiscard]] std::string range_text(const Parameter& parameter);
/// "nodes from the base to the tip; larger is finer"
[[nodiscard]] std::string meaning_text(const Parameter& parameter);
/// "required" or "optional"
[[nodiscard]] const char* need_text(const Parameter& parameter);

}    // namespace stylet::app
