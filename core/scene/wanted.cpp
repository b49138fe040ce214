#include "core/scene/wanted.h"

#include "core/scene/complaints.h"
#include "core/scene/units.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <iterator>
#include <sstream>
#include <string_view>

namespace stylet::core {

std::string wanted_by(const Parameter& parameter) {
    switch (parameter.kind) {
        case Kind::number:
            return wanted_quantity(parameter.unit);
        case Kind::integer:
            return "a whole number without a unit";
        case Kind::text:
            return "text";
        case Kind::choice:
            return "one of " + list_of(choices_of(parameter));
        case Kind::file:
            return "the name of a file inside the scene's folder tree";
        case Kind::vector3:
            return "a list of three [x, y, z], each " + wanted_quantity(parameter.unit);
        case Kind::records:
            break;
    }
    return "a list of maps";
}

std::string bounds_of(const Parameter& parameter) {
    const std::string_view unit = parameter.unit;
    const std::string shown_unit = unit.empty() || unit == "1" ? "" : fmt::format(" {}", unit);
    std::vector<std::string> bounds;
    const auto bound = [&](bool open, const char* open_words, const char* closed_words, double limit) {
        if (std::isfinite(limit)) bounds.push_back(fmt::format("{} {:g}{}", open ? open_words : closed_words, limit, shown_unit));
    };
    const Range& range = parameter.range;
    bound(range.open_below, "more than", "at least", range.least);
    bound(range.open_above, "less than", "at most", range.greatest);
    return fmt::format("{}", fmt::join(bounds, " and "));
}

std::vector<std::string> choices_of(const Parameter& parameter) {
    std::istringstream stream(parameter.choices);
    return {std::istream_iterator<std::string>(stream), {}};
}

}    // namespace stylet::core
