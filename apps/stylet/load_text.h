// Critical loads for people and for programs.
#pragma once

#include "apps/stylet/critical_loads.h"

#include <string>

namespace stylet::app {

/// Tables, and beneath each what it means; scenes of one point each share a table.
[[nodiscard]] std::string loads_text(const CriticalLoads& loads);

/// A row for each point of each scene; names with units.
[[nodiscard]] std::string loads_csv(const CriticalLoads& loads);

/// "clamped-free", as a scene writes it.
[[nodiscard]] std::string word_of(Ends ends);

/// JSON whose layout is a promise to scripts; SI units but for the axis, which says its own; what is not finite is null.
[[nodiscard]] std::string loads_json(const CriticalLoads& loads);

}    // namespace stylet::app
