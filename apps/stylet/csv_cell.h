#pragma once

#include <string>

namespace stylet::app {

/// A cell of CSV as RFC 4180 has it: in quotes where it holds what would end it.
[[nodiscard]] std::string csv_cell(const std::string& text);

}    // namespace stylet::app
