#include "apps/stylet/study_figure.h"

#include "apps/stylet/log_axis.h"
#include "apps/stylet/study_table.h"
#include "apps/stylet/study_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>

namespace stylet::app {
namespace {

using study::Result;
using study::SettingResult;

constexpr double millisecond = 1e3;       // [µs]
constexpr double greatest_shown = 1e4;    // [%] beyond it a number says no more than that it is wrong
constexpr double edge = 0.035;            // share of an axis where a value beyond it is drawn
const std::vector<Guide> error_limits{{1.0, "1 %"}, {5.0, "5 %"}};

/// Least and greatest of what an axis is to show; positive values only.
struct Span {
    double least = std::numeric_limits<double>::infinity(), greatest = 0.0;

    void hold(double value) {
        least = std::min(least, value);
        greatest = std::max(greatest, value);
    }
};

double per_cent(double error) {
    return 100.0 * error;
}

Beyond beyond_of(double error) {
    if (error < least_error) return Beyond::below;
    return per_cent(error) > greatest_shown ? Beyond::above : Beyond::none;
}

bool has_time(const SettingResult& setting) {
    return setting.timing && setting.timing->median > 0.0;
}

bool is_shown(const SettingResult& setting, bool timed) {
    return std::isfinite(setting.error.judged) && (!timed || has_time(setting));
}

/// "Error", and of which cases.
std::string error_label(const Result& result) {
    return result.judged.empty() ? "Error" : "Error, " + result.judged;
}

/// Where the cases' spread is drawn, it lies along x and holds the worst of them as well.
Axis error_axis(const Result& result, bool spread) {
    Span span;
    for (const Guide& limit : error_limits) span.hold(limit.at);
    bool below = result.reference_timing.has_value(), above = false;
    for (const SettingResult& setting : result.settings) {
        if (!std::isfinite(setting.error.judged)) continue;
        const Beyond beyond = beyond_of(setting.error.judged);
        below |= beyond == Beyond::below;
        above |= beyond == Beyond::above;
        if (beyond != Beyond::none) continue;
        span.hold(per_cent(setting.error.judged));
        if (spread && setting.error.worst > 0.0) span.hold(std::min(per_cent(setting.error.worst), greatest_shown));
    }
    constexpr double edge_room = 2.5;    // times: no error is to stand beside what lies beyond the edge
    Axis axis = log_axis(error_label(result), below ? span.least / edge_room : span.least,
                         above ? span.greatest * edge_room : span.greatest, {per_cent_number, spread ? 7 : 14});
    axis.guides = error_limits;
    return axis;
}

/// Where an error is drawn.
double place_of(double error, const Axis& axis) {
    const Beyond beyond = beyond_of(error);
    return beyond == Beyond::below ? axis.at(edge) : beyond == Beyond::above ? axis.at(1.0 - edge) : per_cent(error);
}

/// "Not shown (never punctured): rod, 6 nodes; rod, 11 nodes." for each reason.
std::vector<std::string> not_shown(const Result& result, bool timed) {
    std::vector<std::string> reasons;
    std::map<std::string, std::string> names;    // by reason
    for (const SettingResult& setting : result.settings) {
        if (is_shown(setting, timed)) continue;
        const std::string reason = setting.remarks.empty() ? "" : fmt::format(" ({})", setting.remarks.front());
        std::string& listed = names[reason];
        if (listed.empty()) reasons.push_back(reason);
        listed += (listed.empty() ? "" : "; ") + setting.name();
    }
    std::vector<std::string> notes;
    for (const std::string& reason : reasons) notes.push_back(fmt::format("Not shown{}: {}.", reason, names[reason]));
    return notes;
}

/// What the picture cannot say by itself is told below.
std::vector<std::string> notes_of(const Result& result, bool timed) {
    const auto any = [&](const auto& has) { return std::ranges::any_of(result.settings, has); };
    const bool below = (timed && result.reference_timing) || any([timed](const SettingResult& setting) {
                           return is_shown(setting, timed) && beyond_of(setting.error.judged) == Beyond::below;
                       });
    const bool contended = timed && any([](const SettingResult& setting) { return setting.timing && setting.timing->contended; });
    std::vector<std::string> notes;
    if (below) notes.push_back(fmt::format("{} beyond the axis: an error {}.", timed ? "↓" : "←", error_text(0.0)));
    if (timed && result.own_references)
        notes.emplace_back(
            "Filled: no other setting of its series is both cheaper and nearer. Each series has its own reference.");
    if (contended) notes.push_back(fmt::format("{} the machine had other work.", contended_mark));
    std::ranges::move(not_shown(result, timed), std::back_inserter(notes));
    return notes;
}

/// The curve of this name, made where there is none yet.
Curve& curve_named(const std::string& name, Figure& figure) {
    const auto known = std::ranges::find(figure.curves, name, &Curve::name);
    if (known != figure.curves.end()) return *known;
    return figure.curves.emplace_back(Curve{.name = name, .points = {}, .marks = {}, .look = Look::joined_marks});
}

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

void add_setting(const SettingResult& setting, Figure& figure) {
    Curve& curve = curve_named(setting.series, figure);
    if (!is_shown(setting, true)) {
        curve.points.push_back({nan, nan});
        return;
    }
    const double error = setting.error.judged;
    const Beyond beyond = beyond_of(error);
    const Point at{setting.timing->median, place_of(error, figure.y)};
    curve.points.push_back(beyond == Beyond::none ? at : Point{nan, nan});
    std::string text = setting.label.empty() ? setting.series : setting.label;
    if (beyond == Beyond::above) text += ", " + error_text(error);
    if (setting.timing->contended) text += std::string(" ") + contended_mark;
    curve.marks.push_back({.at = at,
                           .text = text,
                           .filled = setting.on_front,
                           .reach = std::pair{setting.timing->median, setting.timing->p99},
                           .beyond = beyond});
}

/// "6×6×5, to 0.01" and "6×6×5, to 0.001" → "6×6×5, to 0.01, 0.001"
std::string joined_label(const std::string& label, const std::string& more) {
    const auto differ = std::ranges::mismatch(label, more).in1;
    const std::string shared(label.begin(), differ);
    const std::size_t word = shared.rfind(' ') == std::string::npos ? 0 : shared.rfind(' ') + 1;
    return label + ", " + more.substr(word);
}

/// Neighbours in a series that all but cover each other share a label.
void join_labels(Curve& curve, const Figure& figure) {
    constexpr double near = 0.012;    // of the picture
    std::string first;                // the label that `sharer` had alone
    Mark* sharer = nullptr;
    for (Mark& mark : curve.marks) {
        const bool covers = sharer != nullptr && std::abs(figure.x.share(mark.at.x) - figure.x.share(sharer->at.x)) < near &&
                            std::abs(figure.y.share(mark.at.y) - figure.y.share(sharer->at.y)) < near;
        if (covers) {
            sharer->text += joined_label(first, mark.text).substr(first.size());
            mark.text.clear();
        } else {
            sharer = &mark;
            first = mark.text;
        }
    }
}

/// Stairs: with so much time, this error can be had. Empty where errors of different series are not to be compared.
Curve front_of(const Result& result, const Figure& figure) {
    std::vector<Point> steps;
    for (const SettingResult& setting : result.settings) {
        if (!result.own_references && setting.on_front && is_shown(setting, true))
            steps.push_back({setting.timing->median, place_of(setting.error.judged, figure.y)});
    }
    std::ranges::sort(steps, {}, &Point::x);
    Curve front{.name = "Pareto front (filled markers)", .points = {}, .marks = {}, .look = Look::band};
    double error = figure.y.at(0.99);    // a broad line ends a little farther
    for (const Point& step : steps) {
        front.points.push_back({step.x, error});
        front.points.push_back(step);
        error = step.y;
    }
    if (!steps.empty()) front.points.push_back({figure.x.greatest, error});
    return front;
}

Axis time_axis(const Result& result) {
    Span span;
    for (const SettingResult& setting : result.settings) {
        if (!is_shown(setting, true)) continue;
        span.hold(setting.timing->median);
        span.hold(std::max(setting.timing->median, setting.timing->p99));
    }
    if (result.reference_timing) span.hold(result.reference_timing->median);
    constexpr double near = 30.0;    // times; a tick's limit is always shown
    const bool shows_limit =
        result.timed == study::Timed::tick || (span.least < near * millisecond && span.greatest > millisecond / near);
    if (shows_limit) span.hold(millisecond);
    Axis axis = log_axis(fmt::format("Time of {} (median; whisker to the 99th percentile)", each(result.timed)), span.least,
                         span.greatest, {time_number, 12});
    if (shows_limit) axis.guides = {{millisecond, "1 ms"}};
    return axis;
}

Figure figure_over_time(const Result& result) {
    Figure figure{.title = result.title, .x = time_axis(result), .y = error_axis(result, false), .curves = {}};
    figure.notes = notes_of(result, true);
    figure.width = 960.0;
    figure.height = 640.0;
    for (const SettingResult& setting : result.settings) add_setting(setting, figure);
    for (Curve& curve : figure.curves) join_labels(curve, figure);
    // A series of one setting is named beside its point.
    for (Curve& curve : figure.curves) {
        if (curve.marks.size() == 1 && curve.marks.front().text.starts_with(curve.name)) curve.name.clear();
    }
    if (result.reference_timing) {
        const Point at{result.reference_timing->median, figure.y.at(edge)};
        figure.curves.push_back({.name = "",
                                 .points = {},
                                 .marks = {{.at = at, .text = "reference", .filled = false, .beyond = Beyond::below}},
                                 .look = Look::joined_marks,
                                 .grey = true});
    }
    Curve front = front_of(result, figure);
    if (!front.points.empty()) figure.curves.push_back(std::move(front));
    return figure;
}

/// Where errors lie along x.
Beyond sideways(Beyond beyond) {
    return beyond == Beyond::below ? Beyond::left : beyond == Beyond::above ? Beyond::right : Beyond::none;
}

/// To the worst of its cases, as far as the axis reaches.
std::optional<std::pair<double, double>> spread_of(const SettingResult& setting, const Axis& axis) {
    const double judged = per_cent(setting.error.judged), worst = per_cent(setting.error.worst);
    if (beyond_of(setting.error.judged) != Beyond::none || !(worst > judged)) return {};
    return std::pair{judged, std::min(worst, axis.greatest)};
}

/// Where nothing is timed: a line of the picture for each setting, in the order given.
Figure figure_of_errors(const Result& result) {
    std::vector<const SettingResult*> shown;
    for (const SettingResult& setting : result.settings) {
        if (is_shown(setting, false)) shown.push_back(&setting);
    }
    const auto count = static_cast<double>(shown.size());
    Figure figure{.title = result.title,
                  .x = error_axis(result, true),
                  .y = {.label = "", .least = 0.4, .greatest = count + 0.6},
                  .curves = {}};
    for (std::size_t i = 0; i < shown.size(); ++i) {
        const SettingResult& setting = *shown[i];
        const double row = count - static_cast<double>(i);
        figure.y.ticks.push_back({row, setting.name()});
        curve_named(setting.series, figure)
            .marks.push_back({.at = {place_of(setting.error.judged, figure.x), row},
                              .text = "",
                              .reach = spread_of(setting, figure.x),
                              .beyond = sideways(beyond_of(setting.error.judged))});
    }
    if (shown.empty()) figure.y.ticks = {{0.5, "no setting"}};
    for (Curve& curve : figure.curves) curve.name.clear();
    figure.notes = notes_of(result, false);
    constexpr double row_height = 26.0, around = 130.0;
    figure.width = 900.0;
    figure.x.label += result.judged.empty() ? "" : " (whisker to the worst)";
    figure.height = around + row_height * std::max(count, 1.0);
    return figure;
}

}    // namespace

Figure figure_of(const Result& result) {
    const bool timed = std::ranges::any_of(result.settings, [](const SettingResult& setting) { return is_shown(setting, true); });
    return timed ? figure_over_time(result) : figure_of_errors(result);
}

PictureFiles draw_study(const Result& result, const std::filesystem::path& stem) {
    return draw(figure_of(result), stem);
}

}    // namespace stylet::app
