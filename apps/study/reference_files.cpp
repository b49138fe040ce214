#include "apps/study/reference_files.h"

#include "apps/study/recording_file.h"
#include "core/run/sample.h"
#include "core/scene/complaints.h"
#include "core/scene/scene_files.h"
#include "core/scene/units.h"

#include <stylet/error.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>

namespace stylet::study {
namespace {

constexpr std::size_t longest = 1 << 24;    // [bytes] more is no file of known answers

/// The lines of a CSV that say something: neither empty nor begun with #.
class Rows {
public:
    /// Throws Error where the file cannot be read; `what` was wanted.
    Rows(const std::filesystem::path& file, const std::string& what) : name_(file.string()) {
        constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";    // spreadsheets begin UTF-8 with it
        try {
            bytes_ = core::read_bytes(file, longest);
        } catch (const Error& error) {
            throw Error(fmt::format("{}: {}, wanted {}", name_, error.what(), what));
        }
        rest_ = bytes_;
        if (rest_.starts_with(byte_order_mark)) rest_.remove_prefix(byte_order_mark.size());
    }
    Rows(const Rows&) = delete;
    Rows& operator=(const Rows&) = delete;

    bool next() {
        while (!rest_.empty()) {
            const std::size_t end = std::min(rest_.find('\n'), rest_.size());
            line_ = rest_.substr(0, end);
            rest_.remove_prefix(std::min(end + 1, rest_.size()));
            ++number_;
            if (line_.ends_with('\r')) line_.remove_suffix(1);
            if (!line_.empty() && line_.front() != '#') return true;
        }
        line_ = {};
        return false;
    }

    [[nodiscard]] std::string_view line() const { return line_; }

    [[nodiscard]] std::vector<std::string> cells() const {
        std::vector<std::string> cells;
        for (std::string_view rest = line_;;) {
            const std::size_t comma = rest.find(',');
            cells.emplace_back(rest.substr(0, comma));
            if (comma == std::string_view::npos) return cells;
            rest.remove_prefix(comma + 1);
        }
    }

    [[noreturn]] void refuse(const std::string& found, const std::string& wanted) const {
        throw Error(fmt::format("{}:{}: found {}, wanted {}", name_, std::max(1, number_), found, wanted));
    }
    [[noreturn]] void refuse_line(const std::string& wanted) const { refuse(core::quote(std::string(line_)), wanted); }

private:
    std::string name_;
    std::string bytes_;
    std::string_view rest_, line_;
    int number_ = 0;
};

std::optional<double> number_in(std::string_view cell) {
    double number = 0.0;
    const auto [stop, error] = std::from_chars(cell.data(), cell.data() + cell.size(), number);
    const bool whole = error == std::errc{} && stop == cell.data() + cell.size();
    return whole && std::isfinite(number) ? std::optional(number) : std::nullopt;
}

/// How many of the SI unit one of `unit` is; nothing where it measures something else.
std::optional<double> scale_of(const std::string& unit, const std::string& si) {
    if (unit == si) return 1.0;
    const core::Quantity one = core::read_quantity("1 " + unit, si);
    return one.problem.empty() ? std::optional(one.value) : std::nullopt;
}

/// A header's cell: "travel [mm]".
struct Heading {
    std::string name;
    std::string unit;    // "1" where there is none

    explicit Heading(const std::string& cell) {
        const std::size_t bracket = cell.find(" [");
        const bool has_unit = bracket != std::string::npos && cell.ends_with(']');
        name = has_unit ? cell.substr(0, bracket) : cell;
        unit = has_unit ? cell.substr(bracket + 2, cell.size() - bracket - 3) : "1";
    }

    /// Of the SI unit; nothing where it measures something else.
    [[nodiscard]] std::optional<double> scale(const std::string& si) const { return scale_of(unit, si); }
};

std::string with_unit(const std::string& name, const std::string& unit) {
    return unit == "1" ? name : fmt::format("{} [{}]", name, unit);
}

/// The SI unit of a recorded column; "1" of what is none.
std::string unit_of_column(const std::string& name) {
    const core::Column* column = core::column_named(name);
    return column == nullptr ? "1" : column->unit;
}

/// One of a curve's two columns in a file.
struct CurveColumn {
    std::string name;
    std::size_t place;
    double scale;    // to SI
};

CurveColumn find_column(const Rows& rows, const std::string& name) {
    const std::vector<std::string> cells = rows.cells();
    const std::string unit = unit_of_column(name);
    for (std::size_t place = 0; place < cells.size(); ++place) {
        const Heading heading(cells[place]);
        if (heading.name != name) continue;
        if (const auto scale = heading.scale(unit)) return {name, place, *scale};
        rows.refuse(core::quote(cells[place]), fmt::format("a unit of {}, such as {}", name, core::quote(with_unit(name, unit))));
    }
    rows.refuse_line(fmt::format("a header with {}", core::quote(with_unit(name, unit))));
}

/// In SI, whoever has worked on the recording since.
std::vector<double> values_of(const Recording& recording, const std::string& name) {
    const RecordedColumn& column = recording.column(name);
    const std::string unit = unit_of_column(name), found = column.unit.empty() ? "1" : column.unit;
    const auto scale = scale_of(found, unit);
    if (!scale) {
        throw Error(fmt::format("{}: found {}, wanted a unit of {}, such as {}", recording.file.string(),
                                core::quote(with_unit(name, found)), name, core::quote(with_unit(name, unit))));
    }
    std::vector<double> values = column.values;
    for (double& value : values) value *= *scale;
    return values;
}

Outcome curve_of(const Recording& recording, const CurveMeasure& measure) {
    return {.x = values_of(recording, measure.over), .y = values_of(recording, measure.column)};
}

}    // namespace

Outcome curve_file(const std::filesystem::path& file, const CurveMeasure& measure) {
    const std::string what = fmt::format("a CSV with {} and {}", measure.over, measure.column);
    if (is_recording(file)) return curve_of(read_recording(file), measure);
    Rows rows(file, what);
    rows.next();
    const std::array columns{find_column(rows, measure.over), find_column(rows, measure.column)};
    Outcome curve;
    while (rows.next()) {
        const std::vector<std::string> cells = rows.cells();
        for (const CurveColumn& column : columns) {
            const auto number = column.place < cells.size() ? number_in(cells[column.place]) : std::nullopt;
            if (!number) rows.refuse_line(fmt::format("a number for {} in place {}", column.name, column.place + 1));
            (&column == &columns.front() ? curve.x : curve.y).push_back(*number * column.scale);
        }
    }
    if (curve.x.empty()) rows.refuse("no row after the header", what);
    return curve;
}

std::map<std::string, double> table_file(const std::filesystem::path& file, const TableForm& form) {
    const auto or_else = [](const std::string& word, const char* otherwise) { return word.empty() ? otherwise : word; };
    Rows rows(file, fmt::format("a table of {}s", or_else(form.quantity, "value")));
    rows.next();
    const std::vector<std::string> header = rows.cells();
    const Heading of(header.front()), quantity(header.size() == 2 ? header.back() : "");
    const auto scale = quantity.scale(form.unit);
    const bool as_wanted = header.size() == 2 && !of.name.empty() && of.unit == "1" && !quantity.name.empty() && scale &&
                           of.name == or_else(form.of, of.name.c_str()) &&
                           quantity.name == or_else(form.quantity, quantity.name.c_str());
    if (!as_wanted) {
        rows.refuse_line(fmt::format("{} '{},{}'", form.quantity.empty() ? "a header such as" : "the header",
                                     or_else(form.of, "case"), with_unit(or_else(form.quantity, "value"), form.unit)));
    }
    const std::string in = quantity.unit == "1" ? "" : " in " + quantity.unit;
    std::map<std::string, double> values;
    while (rows.next()) {
        const std::vector<std::string> cells = rows.cells();
        const auto number = cells.size() == 2 && !cells.front().empty() ? number_in(cells.back()) : std::nullopt;
        if (!number || (form.above_zero && *number <= 0.0))
            rows.refuse_line(fmt::format("a {}'s name and its {}{}, such as fig3,0.314", of.name, quantity.name, in));
        if (!values.emplace(cells.front(), *number * *scale).second) rows.refuse_line(fmt::format("each {} once", of.name));
    }
    return values;
}

std::string unit_of(const Measure& measure) {
    struct {
        std::string operator()(const CurveMeasure& m) const { return unit_of_column(m.column); }
        std::string operator()(const ValueMeasure& m) const {
            for (const std::string_view extreme : {"peak_", "largest_"}) {    // of a column: peak_hand_force
                if (m.value.starts_with(extreme)) return unit_of_column(m.value.substr(extreme.size()));
            }
            return unit_of_column(m.value);
        }
        std::string operator()(const EventMeasure& m) const { return unit_of_column(m.column); }
        std::string operator()(const AnswerMeasure& /*load*/) const { return "N"; }
    } unit;
    return std::visit(unit, measure);
}

}    // namespace stylet::study
