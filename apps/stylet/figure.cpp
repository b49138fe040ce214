#include "apps/stylet/figure.h"

#include "apps/stylet/failure.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>

namespace stylet::app {
namespace {

/// How a unit of a recording is shown.
struct ShownUnit {
    const char* recorded;
    const char* shown;
    double factor;
};
constexpr std::array shown_units{ShownUnit{"m", "mm", 1e3}, ShownUnit{"J", "mJ", 1e3}};

ShownUnit shown(const study::RecordedColumn& column) {
    for (const ShownUnit& unit : shown_units) {
        if (column.unit == unit.recorded) return unit;
    }
    return {column.unit.c_str(), column.unit.c_str(), 1.0};
}

std::string axis_label(const study::RecordedColumn& column) {
    std::string words = column.name == "travel" ? "hand travel" : column.name == "depth" ? "tip depth" : column.name;
    std::replace(words.begin(), words.end(), '_', ' ');
    words.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(words.front())));
    const std::string unit = shown(column).shown;
    return unit.empty() || unit == "1" ? words : fmt::format("{} ({})", words, unit);
}

bool finite(const Point& point) {
    return std::isfinite(point.x) && std::isfinite(point.y);
}

Curve curve_of(const study::Recording& recording, const std::string& x_name, const std::string& y_name) {
    const study::RecordedColumn& x = recording.column(x_name);
    const study::RecordedColumn& y = recording.column(y_name);
    const double x_factor = shown(x).factor, y_factor = shown(y).factor;
    const auto at = [&](std::size_t row) { return Point{x.values[row] * x_factor, y.values[row] * y_factor}; };

    Curve curve{.name = recording.title, .points = {}, .marks = {}};
    for (std::size_t row = 0; row < x.values.size(); ++row) {
        if (finite(at(row))) curve.points.push_back(at(row));
    }
    if (curve.points.empty()) {
        throw Failure(ExitCode::wrong_input,
                      fmt::format("{}: found no row where both {} and {} are finite", recording.file.string(), x_name, y_name));
    }
    for (const study::RecordedEvent& event : recording.events) {
        // A picture has no room for the details that follow a colon.
        if (finite(at(event.row))) curve.marks.push_back({at(event.row), event.name.substr(0, event.name.find(": "))});
    }
    return curve;
}

/// A curve that comes back within less than a printer's dot needs no further points.
void thin(Curve& curve, const Figure& figure) {
    constexpr double dot = 1.0 / 4000.0;    // of the picture
    const double x_dot = dot * (figure.x.greatest - figure.x.least), y_dot = dot * (figure.y.greatest - figure.y.least);
    std::vector<Point> kept{curve.points.front()};
    for (std::size_t i = 1; i < curve.points.size(); ++i) {
        const Point& point = curve.points[i];
        const bool last = i + 1 == curve.points.size();
        if (last || std::abs(point.x - kept.back().x) > x_dot || std::abs(point.y - kept.back().y) > y_dot) kept.push_back(point);
    }
    curve.points = std::move(kept);
}

bool same_place(const Mark& one, const Mark& other, const Figure& figure) {
    constexpr double near = 0.012;    // of the picture
    return std::hypot(figure.x.share(one.at.x) - figure.x.share(other.at.x),
                      figure.y.share(one.at.y) - figure.y.share(other.at.y)) < near;
}

/// Where a curve has many events, each name is written only once.
void drop_repeated_names(Curve& curve) {
    constexpr std::size_t many = 8;
    if (curve.marks.size() <= many) return;
    std::set<std::string> written;
    for (Mark& mark : curve.marks) {
        if (!written.insert(mark.text).second) mark.text.clear();
    }
}

/// Events of one curve at one place share a marker and a label.
void join_neighbours(Curve& curve, const Figure& figure) {
    std::vector<Mark> marks;
    for (const Mark& mark : curve.marks) {
        if (marks.empty() || !same_place(marks.back(), mark, figure)) {
            marks.push_back(mark);
        } else if (!mark.text.empty()) {
            marks.back().text += marks.back().text.empty() ? mark.text : ", " + mark.text;
        }
    }
    curve.marks = std::move(marks);
}

/// Where several curves do the same at the same place, one label speaks for all.
void share_labels(Figure& figure) {
    std::vector<Mark*> first;
    for (Curve& curve : figure.curves) {
        for (Mark& mark : curve.marks) {
            const auto told = std::find_if(first.begin(), first.end(), [&](const Mark* other) {
                return other->text == mark.text && same_place(*other, mark, figure);
            });
            if (told == first.end()) {
                first.push_back(&mark);
            } else if (!mark.text.empty()) {
                (*told)->shared = true;
                mark.text.clear();
            }
        }
    }
}

}    // namespace

double Axis::share(double value) const {
    if (scale == Scale::logarithmic) return std::log(value / least) / std::log(greatest / least);
    return (value - least) / (greatest - least);
}

double Axis::at(double share) const {
    if (scale == Scale::logarithmic) return least * std::pow(greatest / least, share);
    return std::lerp(least, greatest, share);
}

void drop_shared_beginning(std::vector<Curve>& curves) {
    if (curves.size() < 2) return;
    constexpr const char* colon = ": ";
    const std::size_t end = curves.front().name.find(colon);
    if (end == std::string::npos) return;
    const std::string shared = curves.front().name.substr(0, end + 2);
    const auto has_it = [&shared](const Curve& curve) {
        return curve.name.starts_with(shared) && curve.name.size() > shared.size();
    };
    if (!std::all_of(curves.begin(), curves.end(), has_it)) return;
    for (Curve& curve : curves) curve.name.erase(0, shared.size());
}

void fit_axes(Figure& figure) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    Point least{infinity, 0.0}, greatest{-infinity, 0.0};    // the y axis always shows zero
    for (const Curve& curve : figure.curves) {
        for (const Point& point : curve.points) {
            least = {std::min(least.x, point.x), std::min(least.y, point.y)};
            greatest = {std::max(greatest.x, point.x), std::max(greatest.y, point.y)};
        }
    }
    const double width = greatest.x > least.x ? greatest.x - least.x : 1.0;
    const double height = greatest.y > least.y ? greatest.y - least.y : 1.0;
    constexpr double side = 0.02, headroom = 0.10, below = 0.06;    // of the data's extent
    figure.x.least = least.x - side * width;
    figure.x.greatest = greatest.x + side * width;
    figure.y.least = least.y < 0.0 ? least.y - below * height : 0.0;
    figure.y.greatest = greatest.y + headroom * height;
}

Figure figure_of(const std::vector<study::Recording>& recordings, const std::string& x, const std::string& y) {
    Figure figure;
    figure.x.label = axis_label(recordings.front().column(x));
    figure.y.label = axis_label(recordings.front().column(y));
    for (const study::Recording& recording : recordings) figure.curves.push_back(curve_of(recording, x, y));
    if (figure.curves.size() == 1) figure.title = figure.curves.front().name;
    drop_shared_beginning(figure.curves);
    fit_axes(figure);
    for (Curve& curve : figure.curves) {
        thin(curve, figure);
        drop_repeated_names(curve);
        join_neighbours(curve, figure);
    }
    share_labels(figure);
    return figure;
}

}    // namespace stylet::app
