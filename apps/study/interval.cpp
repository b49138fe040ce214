#include "apps/study/interval.h"

#include "core/scene/complaints.h"

#include <stylet/error.h>

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <string_view>

namespace stylet::study {
namespace {

std::string_view trimmed(std::string_view text) {
    constexpr std::string_view space = " \t";
    const auto begin = text.find_first_not_of(space);
    if (begin == std::string_view::npos) return {};
    return text.substr(begin, text.find_last_not_of(space) - begin + 1);
}

struct Value {
    double number;
    std::string unit;
};

Value read_value(const std::string& whole, std::string_view text) {
    const std::string_view rest = trimmed(text);
    double number = 0.0;
    const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), number);
    if (error != std::errc{} || !std::isfinite(number)) {
        throw Error(
            fmt::format("found {}, wanted a quantity such as '30 mm' or an interval such as 0..50mm", core::quote(whole)));
    }
    return {number, std::string(trimmed(rest.substr(static_cast<std::size_t>(end - rest.data()))))};
}

}    // namespace

double rounded(double value) {
    const std::string digits = fmt::format("{:.12g}", value);
    double read = value;
    std::from_chars(digits.data(), digits.data() + digits.size(), read);
    return read;
}

double Interval::at(double share, Spacing spacing) const {
    if (spacing == Spacing::linear) return std::lerp(from, to, share);
    return std::exp(std::lerp(std::log(from), std::log(to), share));
}

std::vector<double> Interval::values(int count, Spacing spacing) const {
    if (one_value()) return {from};
    std::vector<double> values;
    for (int i = 0; i < count; ++i) values.push_back(rounded(at(static_cast<double>(i) / (count - 1), spacing)));
    values.front() = from;
    values.back() = to;
    return values;
}

std::string Interval::quantity(double value) const {
    return unit.empty() ? fmt::format("{}", value) : fmt::format("{} {}", value, unit);
}

Interval read_interval(const std::string& text) {
    constexpr std::string_view dots = "..";
    const std::size_t at = text.find(dots);
    if (at == std::string::npos) {
        const Value only = read_value(text, text);
        return {only.number, only.number, only.unit, text};
    }
    const Value from = read_value(text, std::string_view(text).substr(0, at));
    const Value to = read_value(text, std::string_view(text).substr(at + dots.size()));
    if (!from.unit.empty() && from.unit != to.unit) {
        throw Error(fmt::format("found {}, wanted one unit for both ends, such as 0..50mm", core::quote(text)));
    }
    if (!(from.number < to.number)) {
        throw Error(fmt::format("found {}, wanted the smaller end first", core::quote(text)));
    }
    return {from.number, to.number, to.unit, text};
}

}    // namespace stylet::study
