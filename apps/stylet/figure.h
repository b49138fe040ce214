// A picture: curves in readable units, those of recordings with their events, and what the axes show.
#pragma once

#include "apps/stylet/recording_file.h"

#include <string>
#include <vector>

namespace stylet::app {

struct Point {
    double x, y;
};

struct Mark {
    Point at;
    std::string text;       // empty: a marker without a label
    bool shared = false;    // the label speaks for other curves' markers at this place too
};

struct Curve {
    std::string name;
    std::vector<Point> points;
    std::vector<Mark> marks;
    bool dotted = false;    // drawn as separate points, over a line that they agree with
};

struct Figure {
    std::string title;    // empty: none
    std::string x_label;
    std::string y_label;
    Point least, greatest;    // what the axes show
    std::vector<Curve> curves;
};

/// Sets the ranges of the axes around all curves; the y axis always shows zero.
void fit_axes(Figure& figure);

/// "Fig. 10(a): L = 150 mm", "Fig. 10(a): L = 200 mm" → a legend that says only what differs.
void drop_shared_beginning(std::vector<Curve>& curves);

/// One curve per recording, of column `y` over column `x`. Throws Failure where a recording lacks one of them or has no finite
/// point.
[[nodiscard]] Figure figure_of(const std::vector<Recording>& recordings, const std::string& x, const std::string& y);

}    // namespace stylet::app
