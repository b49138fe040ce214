#pragma once

#include <stylet/setup.h>

namespace stylet::corotational_fem {

/// What TissueSetup::fixed holds of a block.
[[nodiscard]] inline bool holds_bottom(const TissueSetup& tissue) {
    return tissue.fixed != "sides";
}
[[nodiscard]] inline bool holds_sides(const TissueSetup& tissue) {
    return tissue.fixed != "bottom";
}

}    // namespace stylet::corotational_fem
