#include "core/scene/units.h"

#include "core/scene/complaints.h"

#include <stylet/error.h>

#include <fmt/format.h>
#include <udunits2.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <memory>
#include <mutex>
#include <string_view>

namespace stylet::core {
namespace {

struct Release {
    void operator()(ut_system* system) const { ut_free_system(system); }
    void operator()(ut_unit* unit) const { ut_free(unit); }
    void operator()(cv_converter* converter) const { cv_free(converter); }
};
using UnitSystem = std::unique_ptr<ut_system, Release>;
using Unit = std::unique_ptr<ut_unit, Release>;
using Converter = std::unique_ptr<cv_converter, Release>;

/// The unit database, read once: it costs milliseconds.
ut_system& unit_system() {
    static const UnitSystem system = [] {
        ut_set_error_message_handler(ut_ignore);    // it would write to the terminal
        UnitSystem read(ut_read_xml(nullptr));
        // The database has only "degree", "arcdeg" and the sign.
        const Unit degree(read ? ut_parse(read.get(), "degree", UT_UTF8) : nullptr);
        if (degree) ut_map_symbol_to_unit("deg", UT_UTF8, degree.get());
        return read;
    }();
    if (!system) throw Error("found no UDUNITS-2 unit database: install libudunits2-data or name its file in UDUNITS2_XML_PATH");
    return *system;
}

struct Dimension {
    std::string_view unit, name, example;
};
constexpr std::array dimensions{
    Dimension{"m", "a length", "25 mm"},
    Dimension{"s", "a time", "8 s"},
    Dimension{"kg", "a mass", "2 g"},
    Dimension{"rad", "an angle", "30 deg"},
    Dimension{"1/s", "a rate", "2 1/s"},
    Dimension{"Hz", "a frequency", "1 kHz"},
    Dimension{"m/s", "a speed", "10 mm/s"},
    Dimension{"m/s^2", "an acceleration", "9.81 m/s^2"},
    Dimension{"kg/m^3", "a density", "1000 kg/m^3"},
    Dimension{"Pa", "a pressure", "25 kPa"},
    Dimension{"Pa*s", "a viscosity", "1 Pa*s"},
    Dimension{"N", "a force", "0.66 N"},
    Dimension{"N/m", "a force per length", "5 N/m"},
    Dimension{"N*s/m", "a damping", "0.1 N*s/m"},
    Dimension{"N*m", "a moment", "10 N*mm"},
    Dimension{"N/s", "a force rate", "20 N/s"},
    Dimension{"J", "an energy", "1 mJ"},
    Dimension{"J/m^2", "an energy per area", "164 J/m^2"},
};

std::string_view trimmed(std::string_view text) {
    constexpr std::string_view space = " \t";
    const auto begin = text.find_first_not_of(space);
    if (begin == std::string_view::npos) return {};
    return text.substr(begin, text.find_last_not_of(space) - begin + 1);
}

constexpr double none = std::numeric_limits<double>::quiet_NaN();

Quantity converted(double value, const std::string& text, const std::string& written, const std::string& unit) {
    // UDUNITS-2 reads numbers and dates as units, too ("3", "@ 2000-01-01"): a scene's unit begins with a letter, a sign or "1/".
    constexpr std::string_view begins_no_unit = "0123456789+-.(@^*/";
    constexpr std::size_t longest = 40;    // [bytes]
    const bool odd = begins_no_unit.find(written.front()) != std::string_view::npos && !written.starts_with("1/");
    if (odd || written.size() > longest) return {none, quote(text)};
    static std::mutex mutex;    // UDUNITS-2 keeps its parser's state in globals
    const std::lock_guard lock(mutex);
    const Unit wanted(ut_parse(&unit_system(), unit.c_str(), UT_UTF8));
    if (!wanted) throw Error(fmt::format("UDUNITS-2 does not know the declared unit '{}'", unit));
    const Unit found(ut_parse(&unit_system(), written.c_str(), UT_UTF8));
    if (!found) return {none, fmt::format("{}, whose unit {} is unknown", quote(text), quote(written))};
    const Converter converter(ut_get_converter(found.get(), wanted.get()));
    // A unit with an origin of its own ("m from 5") or a logarithmic one is not a scale of a length.
    if (!converter || cv_convert_double(converter.get(), 0.0) != 0.0) return {none, quote(text)};
    const double si = cv_convert_double(converter.get(), value);
    return std::isfinite(si) ? Quantity{si, ""} : Quantity{none, quote(text) + ", which is not finite"};
}

}    // namespace

Quantity read_quantity(const std::string& text, const std::string& unit) {
    std::string_view rest = trimmed(text);
    if (rest.starts_with('+') && !rest.starts_with("+-")) rest.remove_prefix(1);
    double value = 0.0;
    const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), value);
    if (error == std::errc::invalid_argument) return {none, quote(text)};
    if (error == std::errc::result_out_of_range) return {none, quote(text) + ", which no double can hold"};
    if (!std::isfinite(value)) return {none, quote(text) + ", which is not finite"};
    const std::string written(trimmed(rest.substr(end - rest.data())));
    if (unit == "1" || unit.empty()) {
        if (written.empty()) return {value, ""};
        return {none, quote(text)};
    }
    if (written.empty()) return {none, quote(text) + " without a unit"};
    return converted(value, text, written, unit);
}

std::string example_of(const std::string& unit) {
    const auto found = std::ranges::find(dimensions, unit, &Dimension::unit);
    return found == dimensions.end() ? "1 " + unit : std::string(found->example);
}

std::string wanted_quantity(const std::string& unit) {
    if (unit == "1" || unit.empty()) return "a number without a unit";
    const auto found = std::ranges::find(dimensions, unit, &Dimension::unit);
    const std::string_view name = found == dimensions.end() ? "a quantity" : found->name;
    return fmt::format("{} in {} such as '{}'", name, unit, example_of(unit));
}

}    // namespace stylet::core
