// A picture: curves in readable units, those of recordings with their events, and what the axes show.
#pragma once

#include "apps/study/recording_file.h"

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace stylet::app {

struct Point {
    double x, y;
};

/// Where a value lies that the axes don't reach: the marker stands at that edge, with an arrow across it.
enum class Beyond : std::uint8_t { none, below, above, left, right };

struct Mark {
    Point at;
    std::string text;       // empty: a marker without a label
    bool shared = false;    // the label speaks for other curves' markers at this place too
    // Of Look::joined_marks:
    bool filled = true;
    std::optional<std::pair<double, double>> reach{};    // along x: a whisker
    Beyond beyond = Beyond::none;
};

enum class Look : std::uint8_t {
    line,            // its marks are dots on it
    dots,            // separate points, over a line that they agree with
    joined_marks,    // marks of the curve's own shape, its points a thin line between them
    band             // broad and pale, below everything
};

struct Curve {
    std::string name;             // empty: not in the key
    std::vector<Point> points;    // one that is not finite breaks the line
    std::vector<Mark> marks;
    Look look = Look::line;
    bool grey = false;    // what the others are seen beside
};

/// A number beside an axis.
struct Tick {
    double at;
    std::string text;    // empty: a small tick without one
};

/// A value that matters, drawn across the plot; the text stands outside of it.
struct Guide {
    double at;
    std::string text;
};

enum class Scale : std::uint8_t { linear, logarithmic };

struct Axis {
    std::string label;
    double least = 0.0, greatest = 1.0;    // what it shows
    Scale scale = Scale::linear;
    std::vector<Tick> ticks{};    // none: gnuplot's own
    std::vector<Guide> guides{};

    /// 0 at its least value, 1 at its greatest.
    [[nodiscard]] double share(double value) const;
    /// The value there.
    [[nodiscard]] double at(double share) const;
};

struct Figure {
    std::string title;    // empty: none
    Axis x, y;
    std::vector<Curve> curves;
    std::vector<std::string> notes{};        // below the plot, where they make the picture higher
    double width = 640.0, height = 440.0;    // [pixels], 169 mm × 116 mm in print
};

/// Sets the ranges of the axes around all curves; the y axis always shows zero.
void fit_axes(Figure& figure);

/// "Fig. 10(a): L = 150 mm", "Fig. 10(a): L = 200 mm" → a legend that says only what differs.
void drop_shared_beginning(std::vector<Curve>& curves);

/// One curve per recording, of column `y` over column `x`. Throws Failure where a recording lacks one of them or has no finite
/// point.
[[nodiscard]] Figure figure_of(const std::vector<study::Recording>& recordings, const std::string& x, const std::string& y);

}    // namespace stylet::app
