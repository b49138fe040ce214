#include "apps/study/readable.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

namespace stylet::study {
namespace {

/// 3.1e-05 → 3.1e-5
std::string without_idle_zeros(std::string number) {
    const std::size_t e = number.find('e');
    if (e == std::string::npos) return number;
    return number.substr(0, e + 1) + std::to_string(std::stoi(number.substr(e + 1)));
}

/// So many significant digits; trailing zeros stay, for they are digits as well.
std::string significant(double value, int digits) {
    const double magnitude = std::floor(std::log10(value));
    constexpr double least_fixed = -3.0, most_fixed = 5.0;    // decades in which a number is written out
    if (magnitude < least_fixed || magnitude >= most_fixed) return without_idle_zeros(fmt::format("{:.{}e}", value, digits - 1));
    const int decimals = digits - 1 - static_cast<int>(magnitude);
    return fmt::format("{:.{}f}", value, std::max(0, decimals));
}

/// A study's limits are not reached by rounding: 0.998 % is below 1 %.
int digits_for(double per_cent) {
    constexpr int usual = 2, most = 4;
    int digits = usual;
    for (const double limit : {1.0, 5.0}) {
        while (digits < most && per_cent < limit && std::stod(significant(per_cent, digits)) >= limit) ++digits;
    }
    return digits;
}

}    // namespace

std::string error_text(double error) {
    if (!std::isfinite(error)) return "none";
    if (error < least_error) return fmt::format("< {} %", significant(100.0 * least_error, 1));
    const double per_cent = 100.0 * error;
    return significant(per_cent, digits_for(per_cent)) + " %";
}

std::string time_text(double us) {
    struct Unit {
        double us;
        const char* name;
    };
    constexpr std::array units{Unit{1e6, "s"}, Unit{1e3, "ms"}, Unit{1.0, "µs"}, Unit{1e-3, "ns"}};
    constexpr int digits = 3;
    if (!(us > 0.0)) return "0 ns";
    for (const Unit& unit : units) {
        const double rounded = std::stod(significant(us / unit.us, digits));    // 999.7 µs is 1.00 ms
        if (rounded >= 1.0) return significant(rounded, digits) + " " + unit.name;
    }
    return significant(us / units.back().us, digits) + " " + units.back().name;
}

std::string word_of(Timed timed) {
    switch (timed) {
        case Timed::tick:
            return "tick";
        case Timed::step:
            return "step";
        case Timed::load:
            return "load";
        case Timed::answer:
            return "answer";
        case Timed::nothing:
            break;
    }
    return "";
}

std::string each(Timed timed) {
    return (timed == Timed::answer ? "an " : "a ") + word_of(timed);
}

}    // namespace stylet::study
