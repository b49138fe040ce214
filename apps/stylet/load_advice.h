// What a curve of critical loads means for who holds the needle.
#pragma once

#include "apps/stylet/critical_loads.h"

#include <optional>
#include <string>

namespace stylet::app {

struct LoadAdvice {
    std::optional<bool> buckles_first;    // before the tip punctures; none where nothing limits the tip, or it is in already
    double least;                         // [N] on the axis
    double least_at;                      // on the axis, in its unit
};

[[nodiscard]] LoadAdvice advice_on(const LoadCurve& curve, const SceneLoads& scene, const CriticalLoads& loads);

/// One or two plain sentences on one model: "euler: the needle buckles at 0.6422 N, before its tip punctures at 1 N. …"
[[nodiscard]] std::string advice_text(const LoadCurve& curve, const SceneLoads& scene, const CriticalLoads& loads);

/// "0.6422 N" or "3.852 µN", four digits that count; "unlimited" where it is infinite, "–" where it is no number.
[[nodiscard]] std::string significant(double value, const std::string& unit);

/// "30 mm"
[[nodiscard]] std::string on_axis(double value, const CriticalLoads& loads);

}    // namespace stylet::app
