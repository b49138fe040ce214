#include "apps/stylet/parameter_schema.h"

#include "core/scene/units.h"
#include "core/scene/wanted.h"

#include <fmt/format.h>

#include <cmath>

namespace stylet::app {
namespace {

using nlohmann::ordered_json;

/// YAML has a word such as 2 or true as a number or a truth; a scene may write it so, or in quotes.
ordered_json choice_schema(const Parameter& parameter) {
    ordered_json words = ordered_json::array();
    for (const std::string& word : core::choices_of(parameter)) {
        words.push_back(word);
        if (const ordered_json plain = ordered_json::parse(word, nullptr, false); plain.is_primitive() && !plain.is_discarded()) {
            words.push_back(plain);
        }
    }
    return {{"enum", words}};
}

/// A number and a unit, as units.cpp reads them. A unit scales by a positive factor, so the sign and the zero can be told.
ordered_json quantity_schema(const Parameter& parameter) {
    const Range& range = parameter.range;
    const bool no_negative = range.least >= 0.0, no_zero = no_negative && (range.least > 0.0 || range.open_below);
    const std::string sign = no_negative ? R"(\+?)" : "[+-]?";
    const std::string not_zero = no_zero ? R"((?!0*\.?0*(?:[eE][+-]?\d+)?(?![\d.])))" : "";
    const std::string number = R"((?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?(?![\d.])(?![eE][+-]?\d))";
    const std::string unit = R"((?:1/|[^\s\d+\-.(@^*/]).{0,39})";
    return {{"type", "string"},
            {"pattern", "^[ \\t]*" + sign + not_zero + number + "[ \\t]*" + unit + "$"},
            {"examples", {core::example_of(parameter.unit)}}};
}

ordered_json plain_number_schema(const Parameter& parameter) {
    ordered_json schema{{"type", parameter.kind == Kind::integer ? "integer" : "number"}};
    const Range& range = parameter.range;
    if (std::isfinite(range.least)) schema[range.open_below ? "exclusiveMinimum" : "minimum"] = range.least;
    if (std::isfinite(range.greatest)) schema[range.open_above ? "exclusiveMaximum" : "maximum"] = range.greatest;
    return schema;
}

ordered_json number_schema(const Parameter& parameter) {
    return has_dimension(parameter) ? quantity_schema(parameter) : plain_number_schema(parameter);
}

/// Whatever YAML makes of it, a scene's reader takes the text as it stands.
ordered_json text_schema() {
    return {{"type", {"string", "number", "boolean"}}};
}

ordered_json file_schema() {
    ordered_json schema = text_schema();
    schema["pattern"] = "^[^/]";
    return schema;
}

std::string wanted(const Parameter& parameter) {
    const std::string bounds = core::bounds_of(parameter);
    return core::wanted_by(parameter) + (bounds.empty() ? "" : ", " + bounds);
}

ordered_json vector3_schema(const Parameter& parameter) {
    Parameter component = parameter;
    component.kind = Kind::number;
    ordered_json schema = number_schema(component);
    schema["errorMessage"] = "wanted " + wanted(component);
    return {{"type", "array"}, {"items", schema}, {"minItems", 3}, {"maxItems", 3}};
}

ordered_json records_schema(const Parameter& parameter, const std::string& origin) {
    ordered_json schema{{"type", "array"}, {"items", map_schema(fields_of(parameter), origin)}};
    if (parameter.need == Need::required) schema["minItems"] = 1;
    return schema;
}

ordered_json value_schema(const Parameter& parameter, const std::string& origin) {
    switch (parameter.kind) {
        case Kind::number:
        case Kind::integer:
            return number_schema(parameter);
        case Kind::text:
            return text_schema();
        case Kind::choice:
            return choice_schema(parameter);
        case Kind::file:
            return file_schema();
        case Kind::vector3:
            return vector3_schema(parameter);
        case Kind::records:
            break;
    }
    return records_schema(parameter, origin);
}

ordered_json parameter_schema(const Parameter& parameter, const std::string& origin) {
    ordered_json schema = value_schema(parameter, origin);
    std::string description = fmt::format("{}\n\n{}: {}", parameter.meaning, need_text(parameter), wanted(parameter));
    if (has_dimension(parameter)) description += ". Whether the unit fits, stylet check tells";
    schema["description"] = description + (origin.empty() ? "" : "\n\n" + origin);
    schema["errorMessage"] = fmt::format("wanted {} ({})", wanted(parameter), parameter.meaning);
    return schema;
}

}    // namespace

ordered_json map_schema(ParameterList parameters, const std::string& origin) {
    ordered_json properties = ordered_json::object(), required = ordered_json::array();
    for (const Parameter& parameter : parameters) {
        properties[parameter.name] = parameter_schema(parameter, origin);
        if (parameter.need == Need::required) required.push_back(parameter.name);
    }
    return {{"type", "object"}, {"properties", properties}, {"required", required}, {"additionalProperties", false}};
}

}    // namespace stylet::app
