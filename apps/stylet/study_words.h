// How a study's errors and times read.
#pragma once

#include "apps/study/result.h"

#include <string>

namespace stylet::app {

/// Relative. Below it an error is arithmetic's own.
constexpr double least_error = 1e-14;

/// Of a relative error: "0.42 %", "3.1e-5 %", "< 1e-12 %"; "none" where it is not finite.
[[nodiscard]] std::string error_text(double error);

/// Of microseconds: "420 ns", "12.3 µs", "1.23 ms", "4.5 s".
[[nodiscard]] std::string time_text(double us);

/// What was timed: "tick"; empty where nothing was.
[[nodiscard]] std::string word_of(study::Timed timed);

/// "AMD EPYC 7B13, 2 processors, Linux 6.1; stylet 0.1.0, g++ 12.2.0, Release"
[[nodiscard]] std::string machine_text(const study::Machine& machine);

/// "rod: error ~ needle.rod.nodes^-1.98 (6 points above 3.1e-5 %)"
[[nodiscard]] std::string order_text(const study::FittedOrder& order);

}    // namespace stylet::app
