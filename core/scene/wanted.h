// What a declared parameter asks for, in the words of a scene's errors.
#pragma once

#include <stylet/parameters.h>

#include <string>
#include <vector>

namespace stylet::core {

/// "a length in m such as '25 mm'", "one of bottom, sides", "a list of maps".
[[nodiscard]] std::string wanted_by(const Parameter& parameter);

/// "more than 0 m and at most 1 m"; empty where any number is good.
[[nodiscard]] std::string bounds_of(const Parameter& parameter);

/// The words of a Kind::choice.
[[nodiscard]] std::vector<std::string> choices_of(const Parameter& parameter);

}    // namespace stylet::core
