// Errors and times as people read them.
#pragma once

#include "apps/study/study.h"

#include <string>

namespace stylet::study {

/// Relative. Below it an error is arithmetic's own.
constexpr double least_error = 1e-14;

/// Of a relative error: "0.42 %", "3.1e-5 %", "< 1e-12 %"; "none" where it is not finite.
[[nodiscard]] std::string error_text(double error);

/// Of microseconds: "420 ns", "12.3 µs", "1.23 ms", "4.5 s".
[[nodiscard]] std::string time_text(double us);

/// What was timed: "tick"; empty where nothing was.
[[nodiscard]] std::string word_of(Timed timed);

/// "a tick", "an answer"
[[nodiscard]] std::string each(Timed timed);

}    // namespace stylet::study
