#include "apps/stylet/plugin_text.h"

#include "apps/stylet/kinds.h"
#include "apps/stylet/table.h"

#include <fmt/format.h>

#include <sstream>
#include <vector>

namespace stylet::app {
namespace {

constexpr std::size_t page_width = 110;    // [characters]

void add_rows(ParameterList parameters, std::size_t indent, Table& table) {
    for (const Parameter& parameter : parameters) {
        table.add({std::string(indent, ' ') + parameter.name, kind_text(parameter), range_text(parameter), need_text(parameter)});
        add_rows(fields_of(parameter), indent + 4, table);
    }
}

/// The meanings in the order of the rows, each indented to stand below its name.
void add_meanings(ParameterList parameters, std::size_t indent, std::vector<std::string>& meanings) {
    for (const Parameter& parameter : parameters) {
        meanings.push_back(wrapped(meaning_text(parameter), indent + 4, page_width));
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

/// Its lines as they are: their breaks and blanks mean something.
std::string formula_text(const char* formula) {
    std::istringstream lines(formula);
    std::string text;
    for (std::string line; std::getline(lines, line);) text += "    " + line + "\n";
    return text;
}

}    // namespace

std::string plugin_text(const core::PluginLibrary& library) {
    const Descriptor& plugin = library.descriptor();
    const About& about = plugin.about;
    return fmt::format("{} ({}): {}\nformula:\n{}source:\n{}validity:\n{}library:\n    {}\n\n{}", plugin.name,
                       core::name_of(plugin.role), about.summary, formula_text(about.formula),
                       wrapped(about.source, 4, page_width), wrapped(about.validity, 4, page_width), library.file().string(),
                       parameters_text(parameters_of(plugin)));
}

}    // namespace stylet::app
