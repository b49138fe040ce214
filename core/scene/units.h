// Numbers with units. The only door to UDUNITS-2.
#pragma once

#include <string>

namespace stylet::core {

/// A quantity as read: its value in SI, or what was found instead of one.
struct Quantity {
    double value;
    std::string problem;    // "'25' without a unit"; empty where `value` holds
};

/// Reads "25 kPa" as a number of `unit` ("Pa"). A number with a dimension must carry its unit; where `unit` is "1" it must carry
/// none. Not finite is a problem, too. Throws Error where the unit database is missing or does not know `unit`.
[[nodiscard]] Quantity read_quantity(const std::string& text, const std::string& unit);

/// "25 kPa" of "Pa": how a scene may write a quantity of `unit`.
[[nodiscard]] std::string example_of(const std::string& unit);

/// "a pressure in Pa such as '25 kPa'", "a number without a unit".
[[nodiscard]] std::string wanted_quantity(const std::string& unit);

}    // namespace stylet::core
