// One step coarser or finer, of a parameter that buys accuracy with time.
#pragma once

#include <stylet/parameters.h>

#include <cstdint>
#include <optional>
#include <string>

namespace stylet::study {

enum class Step : std::uint8_t { coarser, finer };

/// The parameter's value, as YAML, one step on from the one it has; nothing where it has none, where no way of it is finer, and
/// where its range or its words end. A number halves or doubles (an odd count stays one of points between which gaps halve or
/// double: 41, 21, 11), a vector grows or shrinks by a half in each component, a choice takes the next word.
[[nodiscard]] std::optional<std::string> one_step(const Parameter& parameter, const Parameters& given, Step step);

/// "2.5 mm" of 0.0025 and "m": a number of this unit as a scene may write it.
[[nodiscard]] std::string written(double value, const std::string& unit);

}    // namespace stylet::study
