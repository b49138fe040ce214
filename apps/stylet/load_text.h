// Critical loads for people.
#pragma once

#include "apps/stylet/critical_loads.h"

#include <string>

namespace stylet::app {

/// Tables, and beneath each what it means; scenes of one point each share a table.
[[nodiscard]] std::string loads_text(const CriticalLoads& loads);

/// "clamped-free", as a scene writes it.
[[nodiscard]] std::string word_of(Ends ends);

}    // namespace stylet::app
