#include "apps/stylet/page.h"

#include "apps/stylet/table.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace stylet::app {
namespace {

constexpr double trace_step = 2.0;    // pixels

double text_width(const std::string& text, double font) {
    constexpr double mean_letter = 0.58;    // of the font size, DejaVu Sans
    return mean_letter * font * static_cast<double>(width_of(text));
}

Box grown(const Box& box, double by) {
    return {box.left - by, box.top - by, box.right + by, box.bottom + by};
}

Point nearest(const Box& box, const Point& point) {
    return {std::clamp(point.x, box.left, box.right), std::clamp(point.y, box.top, box.bottom)};
}

/// A box of this size whose nearest point is `distance` away from `anchor` in direction `angle`.
Box box_beside(const Point& anchor, double angle, double distance, double box_width, double box_height) {
    const double x = std::cos(angle), y = -std::sin(angle);
    const Point centre{anchor.x + x * distance + x * box_width / 2.0, anchor.y + y * distance + y * box_height / 2.0};
    return {centre.x - box_width / 2.0, centre.y - box_height / 2.0, centre.x + box_width / 2.0, centre.y + box_height / 2.0};
}

std::vector<Point> stepped(const Point& from, const Point& to) {
    const int steps = std::max(1, static_cast<int>(std::hypot(to.x - from.x, to.y - from.y) / trace_step));
    std::vector<Point> points;
    for (int i = 0; i < steps; ++i) {
        const double t = static_cast<double>(i) / steps;
        points.push_back({from.x + t * (to.x - from.x), from.y + t * (to.y - from.y)});
    }
    return points;
}

}    // namespace

Page::Page(const Figure& figure) : figure_(figure), plot_{78.0, figure.title.empty() ? 16.0 : 46.0, width - 18.0, height - 62.0} {
    trace_curves();
    if (figure.curves.size() > 1) place_key();
    place_labels();
}

Point Page::pixel(const Point& point) const {
    const double x = (point.x - figure_.least.x) / (figure_.greatest.x - figure_.least.x);
    const double y = (point.y - figure_.least.y) / (figure_.greatest.y - figure_.least.y);
    return {plot_.left + x * (plot_.right - plot_.left), plot_.bottom - y * (plot_.bottom - plot_.top)};
}

void Page::trace_curves() {
    for (const Curve& curve : figure_.curves) {
        for (std::size_t i = 1; i < curve.points.size(); ++i) {
            const std::vector<Point> piece = stepped(pixel(curve.points[i - 1]), pixel(curve.points[i]));
            traces_.insert(traces_.end(), piece.begin(), piece.end());
        }
        for (const Mark& mark : curve.marks) markers_.push_back(pixel(mark.at));
    }
}

double Page::cover(const Box& box) const {
    const Box near = grown(box, 2.0);
    const auto under = [&near](const Point& point) { return near.holds(point); };
    return trace_step * static_cast<double>(std::count_if(traces_.begin(), traces_.end(), under)) +
           30.0 * static_cast<double>(std::count_if(markers_.begin(), markers_.end(), under));
}

void Page::place_key() {
    double longest = 0.0;
    for (const Curve& curve : figure_.curves) longest = std::max(longest, text_width(curve.name, font));
    const double key_width = key_sample + longest + 8.0, key_height = key_line * static_cast<double>(figure_.curves.size()) + 6.0;
    constexpr double gap = 10.0;
    const double left = plot_.left + gap, right = plot_.right - gap - key_width;
    const double top = plot_.top + gap, bottom = plot_.bottom - gap - key_height;
    double best = std::numeric_limits<double>::infinity();
    for (const Point& corner : {Point{left, top}, Point{right, top}, Point{right, bottom}, Point{left, bottom},
                                Point{(left + right) / 2.0, top}, Point{(left + right) / 2.0, bottom}}) {
        const Box box{corner.x, corner.y, corner.x + key_width, corner.y + key_height};
        if (cover(box) < best) {
            best = cover(box);
            key_ = box;
        }
    }
}

void Page::place_labels() {
    constexpr double far_apart = 14.0;    // pixels from which a leader shows where a label belongs
    for (std::size_t c = 0; c < figure_.curves.size(); ++c) {
        for (const Mark& mark : figure_.curves[c].marks) {
            if (mark.text.empty()) continue;
            const Point anchor = pixel(mark.at);
            const double label_width = text_width(mark.text, label_font) + 4.0, label_height = 1.25 * label_font;
            double best = std::numeric_limits<double>::infinity();
            PlacedLabel label{mark.text, c, {}, {}};
            if (mark.shared) label.curve.reset();
            for (const double distance : {7.0, 12.0, 20.0, 30.0, 44.0, 60.0, 80.0, 110.0}) {
                for (int direction = 0; direction < 16; ++direction) {
                    const double angle = std::numbers::pi * direction / 8.0;
                    const Box box = box_beside(anchor, angle, distance, label_width, label_height);
                    if (!box.lies_in(grown(plot_, -3.0)) || (key_ && box.meets(*key_))) continue;
                    double cost = 3.0 * cover(box) + distance + 2.0 * std::abs(std::sin(angle / 2.0));
                    for (const PlacedLabel& other : labels_) {
                        if (box.meets(grown(other.box, 2.0))) cost += 1000.0;
                        if (other.leader && (box.holds(other.leader->first) || box.holds(other.leader->second))) cost += 200.0;
                    }
                    if (cost >= best) continue;
                    best = cost;
                    label.box = box;
                    label.leader.reset();
                    if (distance > far_apart) label.leader = std::pair{anchor, nearest(box, anchor)};
                }
            }
            if (std::isfinite(best)) labels_.push_back(label);
        }
    }
}

}    // namespace stylet::app
