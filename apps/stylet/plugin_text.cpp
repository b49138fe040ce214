#include "apps/stylet/plugin_text.h"

#include "apps/stylet/kinds.h"
#include "apps/stylet/table.h"

#include <fmt/format.h>

#include <cmath>
#include <sstream>
#include <vector>

namespace stylet::app {
namespace {

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

}    // namespace

std::string plugin_text(const core::PluginLibrary& library) {
    const Descriptor& plugin = library.descriptor();
    return fmt::format("{} ({}): {}\nsource: {}\nlibrary: {}\n\n{}", plugin.name, core::name_of(plugin.role),
                       plugin.about.summary, plugin.about.source, library.file().string(),
                       parameters_text(parameters_of(plugin)));
}

}    // namespace stylet::app
