#include "apps/study/fineness.h"

#include "core/scene/wanted.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace stylet::study {
namespace {

constexpr double number_step = 2.0;
constexpr double vector_step = 1.5;    // of each component: its cells are three and a bit as many

bool grows(const Parameter& parameter, Step step) {
    return (parameter.finer == Finer::above) == (step == Step::finer);
}

/// Within the range, at its end where the value is beyond; nothing where the end itself is not within.
std::optional<double> bounded(double value, const Range& range) {
    if (value < range.least || (range.open_below && value == range.least))
        return range.open_below ? std::nullopt : std::optional(range.least);
    if (value > range.greatest || (range.open_above && value == range.greatest))
        return range.open_above ? std::nullopt : std::optional(range.greatest);
    return value;
}

double scaled(double value, double by, bool up) {
    return up ? value * by : value / by;
}

std::optional<std::string> stepped_integer(std::int64_t count, const Range& range, bool up) {
    const bool points = count % 2 == 1 && count > 1;    // one more than the gaps between them
    const auto gaps = static_cast<double>(points ? count - 1 : count);
    const double next = std::round(scaled(gaps, number_step, up)) + (points ? 1.0 : 0.0);
    const auto within = bounded(next, range);
    if (!within || std::llround(*within) == count) return std::nullopt;
    return std::to_string(std::llround(*within));
}

std::optional<std::string> stepped_number(double value, const Parameter& parameter, bool up) {
    const auto within = bounded(scaled(value, number_step, up), parameter.range);
    if (!within || *within == value) return std::nullopt;
    return written(*within, parameter.unit);
}

/// Counts, which cells are, stay whole and positive.
std::optional<std::string> stepped_vector(const Vector3& value, const Parameter& parameter, bool up) {
    const bool counts = std::string_view(parameter.unit) == "1" && value == value.array().round().matrix();
    std::string text;
    bool moved = false;
    for (Eigen::Index i = 0; i < 3; ++i) {
        double next = scaled(value[i], vector_step, up);
        if (counts) next = std::max(1.0, std::round(next));
        const auto within = bounded(next, parameter.range);
        if (!within) return std::nullopt;
        moved |= *within != value[i];
        text += (text.empty() ? "[" : ", ") + written(*within, parameter.unit);
    }
    return moved ? std::optional(text + "]") : std::nullopt;
}

std::optional<std::string> stepped_choice(const std::string& word, const Parameter& parameter, bool up) {
    const std::vector<std::string> words = core::choices_of(parameter);
    const auto at = std::ranges::find(words, word);
    if (at == words.end() || (up ? at + 1 == words.end() : at == words.begin())) return std::nullopt;
    return up ? *(at + 1) : *(at - 1);
}

bool takes_prefix(const std::string& unit) {
    static const std::vector<std::string> units{"m", "s", "Hz", "N", "Pa", "J"};
    return std::ranges::find(units, unit) != units.end();
}

}    // namespace

std::string written(double value, const std::string& unit) {
    constexpr int digits = 6;
    if (unit == "1") return fmt::format("{:.{}g}", value, digits);
    struct Prefix {
        double factor;
        const char* name;
    };
    static constexpr Prefix prefixes[] = {{1e9, "G"}, {1e6, "M"}, {1e3, "k"}, {1.0, ""}, {1e-3, "m"}, {1e-6, "u"}};
    const double most = unit == "s" ? 1.0 : prefixes[0].factor;    // nobody counts in kiloseconds
    const auto fits = [&](const Prefix& prefix) {
        return prefix.factor <= most && std::abs(value) >= prefix.factor * (1.0 - 1e-9);
    };
    const auto* const prefix = takes_prefix(unit) ? std::ranges::find_if(prefixes, fits) : std::end(prefixes);
    if (prefix == std::end(prefixes)) return fmt::format("{:.{}g} {}", value, digits, unit);
    return fmt::format("{:.{}g} {}{}", value / prefix->factor, digits, prefix->name, unit);
}

std::optional<std::string> one_step(const Parameter& parameter, const Parameters& given, Step step) {
    if (parameter.finer == Finer::neither || !given.has(parameter.name)) return std::nullopt;
    const bool up = grows(parameter, step);
    switch (parameter.kind) {
        case Kind::integer:
            return stepped_integer(given.integer(parameter.name), parameter.range, up);
        case Kind::number:
            return stepped_number(given.number(parameter.name), parameter, up);
        case Kind::vector3:
            return stepped_vector(given.vector3(parameter.name), parameter, up);
        case Kind::choice:
            return stepped_choice(given.text(parameter.name), parameter, up);
        case Kind::text:
        case Kind::file:
        case Kind::records:
            break;
    }
    return std::nullopt;
}

}    // namespace stylet::study
