// Critical loads for programs.
#pragma once

#include "apps/stylet/critical_loads.h"

#include <string>

namespace stylet::app {

/// A row for each point of each scene; names with units.
[[nodiscard]] std::string loads_csv(const CriticalLoads& loads);

/// JSON whose layout is a promise to scripts; SI units but for the axis, which says its own; what is not finite is null.
[[nodiscard]] std::string loads_json(const CriticalLoads& loads);

}    // namespace stylet::app
