#include "apps/stylet/log_axis.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace stylet::app {
namespace {

std::string superscript(int number) {
    constexpr std::array digits{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    std::string text = number < 0 ? "⁻" : "";
    for (const char digit : std::to_string(std::abs(number))) text += digits.at(static_cast<std::size_t>(digit - '0'));
    return text;
}

/// Numbers stand at every decade; at each second or third one where there are many, at 2 and 5 as well where there are few.
std::vector<Tick> ticks_between(double least, double greatest, const Numbers& numbers) {
    constexpr double few = 2.5;    // decades
    const int first = static_cast<int>(std::floor(std::log10(least))), last = static_cast<int>(std::ceil(std::log10(greatest)));
    const int stride = 1 + (last - first) / (numbers.most + 1);
    const bool between = std::log10(greatest / least) < few;
    std::vector<Tick> ticks;
    const auto add = [&](double at, bool told) {
        if (at >= least && at <= greatest) ticks.push_back({at, told ? numbers.text(at) : ""});
    };
    for (int decade = first; decade <= last; ++decade) {
        const double power = std::pow(10.0, decade);
        add(power, decade % stride == 0);
        for (int digit = 2; digit <= 9 && stride == 1; ++digit) add(digit * power, between && (digit == 2 || digit == 5));
    }
    return ticks;
}

}    // namespace

Axis log_axis(const std::string& label, double least, double greatest, const Numbers& numbers) {
    constexpr double share = 0.06, least_decades = 0.15;    // room on either side
    const double room = std::pow(10.0, std::max(least_decades, share * std::log10(greatest / least)));
    Axis axis{.label = label, .least = least / room, .greatest = greatest * room, .scale = Scale::logarithmic};
    axis.ticks = ticks_between(axis.least, axis.greatest, numbers);
    return axis;
}

std::string time_number(double us) {
    struct Unit {
        double us;
        const char* name;
    };
    constexpr std::array units{Unit{1e6, "s"}, Unit{1e3, "ms"}, Unit{1.0, "µs"}};
    constexpr double nearly = 1.0 - 1e-9;    // powers of ten are rounded
    for (const Unit& unit : units) {
        if (us >= nearly * unit.us) return fmt::format("{:.6g} {}", us / unit.us, unit.name);
    }
    return fmt::format("{:.6g} ns", 1e3 * us);
}

std::string per_cent_number(double per_cent) {
    constexpr double least = 0.9e-3, greatest = 1.1e4;    // of those that are written out
    if (per_cent > least && per_cent < greatest) return fmt::format("{:.6g} %", per_cent);
    const int decade = static_cast<int>(std::floor(std::log10(per_cent * 1.000001)));
    const double digit = std::round(per_cent / std::pow(10.0, decade));
    return fmt::format("{}10{} %", digit > 1.0 ? fmt::format("{:.0f}·", digit) : "", superscript(decade));
}

}    // namespace stylet::app
