// Several timings as one.
#pragma once

#include "apps/study/result.h"

namespace stylet::study {

/// More than this share of the wall time without a processor, and a timing is not trusted.
inline constexpr double most_waited = 0.02;

/// Of repetitions of one thing, in any order: medians of the quietest `count`. Contended where one of those waited too long.
[[nodiscard]] Timing of_repetitions(std::vector<Timing> timings, int count);

/// Of several cases: the median of their medians and p99s, the worst of all. Contended where more than half of them are: less
/// doesn't reach a median.
[[nodiscard]] Timing of_cases(const std::vector<Timing>& timings);

}    // namespace stylet::study
