// What one run, or one answer, left behind for a study.
#pragma once

#include "apps/study/result.h"

#include <optional>
#include <string>
#include <vector>

namespace stylet::study {

struct Outcome {
    std::vector<double> x;    // of a curve, SI, growing; empty where one value is measured
    std::vector<double> y;    // SI, as many as x, or one value
    std::string missing{};    // why there is no value: "never punctured"; empty where there is
    std::vector<std::string> remarks{};
    std::optional<Timing> timing{};
    bool punctured = false;    // the tissue, on the way
};

}    // namespace stylet::study
