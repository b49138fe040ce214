#pragma once

#include <string>

namespace stylet::app {

/// Plain text as Markdown: what would be read as markup is escaped, but for code in backticks.
[[nodiscard]] std::string markdown(const std::string& text);

}    // namespace stylet::app
