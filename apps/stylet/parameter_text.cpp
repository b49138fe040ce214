#include "apps/stylet/parameter_text.h"

#include "apps/stylet/table.h"

#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <sstream>
#include <vector>

namespace stylet::app {
namespace {

using nlohmann::ordered_json;

const char* name_of(Kind kind) {
    switch (kind) {
        case Kind::number:
            return "number";
        case Kind::integer:
            return "whole number";
        case Kind::text:
            return "text";
        case Kind::choice:
            return "choice";
        case Kind::file:
            return "file";
        case Kind::vector3:
            return "[x, y, z]";
        case Kind::records:
            return "list of maps";
    }
    return "";
}

bool is_numeric(Kind kind) {
    return kind == Kind::number || kind == Kind::integer;
}

std::vector<std::string> words_of(const char* text) {
    std::istringstream stream(text);
    return {std::istream_iterator<std::string>(stream), {}};
}

std::string kind_text(const Parameter& parameter) {
    const std::string unit = parameter.unit;
    if (unit.empty()) return name_of(parameter.kind);
    return fmt::format("{} ({})", name_of(parameter.kind), unit == "1" ? "no unit" : unit);
}

std::string range_text(const Parameter& parameter) {
    if (parameter.kind == Kind::choice) return fmt::format("{}", fmt::join(words_of(parameter.choices), " | "));
    if (!is_numeric(parameter.kind)) return "";
    const Range& range = parameter.range;
    const bool below = std::isfinite(range.least), above = std::isfinite(range.greatest);
    const std::string least = fmt::format("{} {}", range.open_below ? ">" : "≥", range.least);
    const std::string greatest = fmt::format("{} {}", range.open_above ? "<" : "≤", range.greatest);
    if (below && above) return least + " and " + greatest;
    if (below) return least;
    if (above) return greatest;
    return "any";
}

const char* need_text(const Parameter& parameter) {
    return parameter.need == Need::required ? "required" : "optional";
}

void add_rows(ParameterList parameters, std::size_t indent, Table& table) {
    for (const Parameter& parameter : parameters) {
        table.add({std::string(indent, ' ') + parameter.name, kind_text(parameter), range_text(parameter), need_text(parameter)});
        add_rows(fields_of(parameter), indent + 4, table);
    }
}

/// The meanings in the order of the rows, each indented to stand below its name.
void add_meanings(ParameterList parameters, std::size_t indent, std::vector<std::string>& meanings) {
    constexpr std::size_t page = 110;
    for (const Parameter& parameter : parameters) {
        meanings.push_back(wrapped(parameter.meaning, indent + 4, page));
        add_meanings(fields_of(parameter), indent + 4, meanings);
    }
}

ordered_json bound(double value) {
    return std::isfinite(value) ? ordered_json(value) : ordered_json(nullptr);
}

ordered_json parameter_json(const Parameter& parameter) {
    ordered_json json{{"name", parameter.name},
                      {"kind", name_of(parameter.kind)},
                      {"unit", parameter.unit},
                      {"required", parameter.need == Need::required},
                      {"meaning", parameter.meaning}};
    if (is_numeric(parameter.kind)) {
        json["range"] = {{"least", bound(parameter.range.least)},
                         {"open_below", parameter.range.open_below},
                         {"greatest", bound(parameter.range.greatest)},
                         {"open_above", parameter.range.open_above}};
    }
    if (parameter.kind == Kind::choice) json["choices"] = words_of(parameter.choices);
    if (parameter.kind == Kind::records) json["fields"] = parameters_json(fields_of(parameter));
    return json;
}

}    // namespace

std::string parameters_text(ParameterList parameters) {
    if (parameters.empty()) return "  no parameters of its own\n";
    using Align = Table::Align;
    Table table({Align::left, Align::left, Align::left, Align::left});
    table.add({"parameter", "kind (unit)", "range (SI)", "needed"});
    add_rows(parameters, 0, table);
    std::vector<std::string> meanings{""};
    add_meanings(parameters, 2, meanings);

    std::istringstream rows(table.text(2));
    std::string text, row;
    for (const std::string& meaning : meanings) {
        std::getline(rows, row);
        text += row + "\n" + meaning;
    }
    return text;
}

ordered_json parameters_json(ParameterList parameters) {
    ordered_json all = ordered_json::array();
    for (const Parameter& parameter : parameters) all.push_back(parameter_json(parameter));
    return all;
}

}    // namespace stylet::app
