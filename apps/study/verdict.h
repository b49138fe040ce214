#pragma once

#include "apps/study/result.h"

namespace stylet::study {

/// Marks the Pareto front in the settings and closes the result with the sentences a reader is after: the cheapest setting under
/// 1 % and under 5 %, and the most accurate within 1 ms, by their judged errors and median times; how far off the nearest is
/// where there is none. A tick that keeps within 1 ms in the median but not in one of a hundred is said to. Where nothing was
/// timed: how many settings are under each limit, and the coarsest of them. The reference among its own settings would win
/// everything: it is named, and takes no part. Where each series has a reference of its own, series are not compared: each has
/// its own front and sentences.
void add_verdict(Result& result);

}    // namespace stylet::study
