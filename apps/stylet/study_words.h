// How what a study found reads.
#pragma once

#include "apps/study/readable.h"
#include "apps/study/result.h"

#include <string>

namespace stylet::app {

using study::each;
using study::error_text;
using study::least_error;
using study::time_text;
using study::word_of;

/// "AMD EPYC 7B13, 2 processors, Linux 6.1; stylet 0.1.0, g++ 12.2.0, Release"
[[nodiscard]] std::string machine_text(const study::Machine& machine);

/// "a tick, 5 repetitions, 1 thread"; empty where nothing was timed.
[[nodiscard]] std::string timed_text(const study::Result& result);

/// "never punctured; found no equilibrium in 3 ticks"
[[nodiscard]] std::string remarks_text(const study::SettingResult& setting);

/// "rod: error ~ needle.rod.nodes^-1.98 (6 points above 3.1e-5 %)"
[[nodiscard]] std::string order_text(const study::FittedOrder& order);

}    // namespace stylet::app
