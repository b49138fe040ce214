// Logarithmic axes with a number at every decade.
#pragma once

#include "apps/stylet/figure.h"

#include <string>

namespace stylet::app {

/// How numbers stand beside an axis.
struct Numbers {
    std::string (*text)(double);
    int most;    // decades that there is room to number
};

/// From `least` to `greatest`, both positive, with room on either side.
[[nodiscard]] Axis log_axis(const std::string& label, double least, double greatest, const Numbers& numbers);

/// Of microseconds: "2 µs", "100 ms".
[[nodiscard]] std::string time_number(double us);

/// Of per cent: "0.1 %", "10⁻⁷ %".
[[nodiscard]] std::string per_cent_number(double per_cent);

}    // namespace stylet::app
