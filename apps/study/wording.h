// How a page calls what a study asks.
#pragma once

#include "apps/study/study.h"

namespace stylet::study {

[[nodiscard]] std::string scenes_words(const Study& study);         // "../paper/fig10a_l150.yaml", as seen from the study
[[nodiscard]] std::string measure_words(const Measure& measure);    // "RMS of hand_force over travel, …"
[[nodiscard]] std::string reference_words(const Study& study);      // "elliptic integrals (closed form)"
[[nodiscard]] std::string judge_words(const Study& study);          // "median of 200 cases"; empty where there is one case

}    // namespace stylet::study
