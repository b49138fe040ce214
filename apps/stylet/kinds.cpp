#include "apps/stylet/kinds.h"

#include "core/scene/wanted.h"

#include <fmt/format.h>

#include <cmath>
#include <string_view>
#include <vector>

namespace stylet::app {

const char* name_of(Kind kind) {
    switch (kind) {
        case Kind::number:
            return "number";
        case Kind::integer:
            return "whole number";
        case Kind::text:
            return "text";
        case Kind::choice:
            return "choice";
        case Kind::file:
            return "file";
        case Kind::vector3:
            return "[x, y, z]";
        case Kind::records:
            return "list of maps";
    }
    return "";
}

bool has_range(Kind kind) {
    return kind == Kind::number || kind == Kind::integer || kind == Kind::vector3;
}

bool has_dimension(const Parameter& parameter) {
    const std::string_view unit = parameter.unit;
    return !unit.empty() && unit != "1";
}

std::string kind_text(const Parameter& parameter) {
    const std::string unit = parameter.unit;
    if (unit.empty()) return name_of(parameter.kind);
    return fmt::format("{} ({})", name_of(parameter.kind), has_dimension(parameter) ? unit : "no unit");
}

namespace {

/// "bottom | sides"; of a long list only its ends.
std::string choices_text(const std::vector<std::string>& words) {
    constexpr std::size_t longest = 12;
    if (words.size() <= longest) return fmt::format("{}", fmt::join(words, " | "));
    return fmt::format("{} | {} | … | {}", words[0], words[1], words.back());
}

}    // namespace

std::string range_text(const Parameter& parameter) {
    if (parameter.kind == Kind::choice) return choices_text(core::choices_of(parameter));
    if (!has_range(parameter.kind)) return "";
    const Range& range = parameter.range;
    const bool below = std::isfinite(range.least), above = std::isfinite(range.greatest);
    std::string least = fmt::format("{} {}", range.open_below ? ">" : "≥", range.least);
    std::string greatest = fmt::format("{} {}", range.open_above ? "<" : "≤", range.greatest);
    if (below && above) return least + " and " + greatest;
    if (below) return least;
    if (above) return greatest;
    return "any";
}

std::string meaning_text(const Parameter& parameter) {
    if (parameter.finer == Finer::neither) return parameter.meaning;
    const bool above = parameter.finer == Finer::above;
    if (parameter.kind == Kind::choice)
        return fmt::format("{}; {} words are finer", parameter.meaning, above ? "later" : "earlier");
    return fmt::format("{}; {} is finer", parameter.meaning, above ? "larger" : "smaller");
}

const char* need_text(const Parameter& parameter) {
    return parameter.need == Need::required ? "required" : "optional";
}

}    // namespace stylet::app
