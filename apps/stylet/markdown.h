#pragma once

#include <string>

namespace stylet::app {

/// Plain text as Markdown: what would be read as markup is escaped, but for code in backticks.
[[nodiscard]] std::string markdown(const std::string& text);

/// The same in a table, where a bar would end the cell, in code or not.
[[nodiscard]] std::string markdown_cell(const std::string& text);

}    // namespace stylet::app
