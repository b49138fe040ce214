#include "apps/stylet/page.h"

#include "apps/stylet/table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <sstream>
#include <utility>

namespace stylet::app {
namespace {

using Line = std::pair<Point, Point>;

constexpr double trace_step = 2.0;    // pixels
constexpr double key_edge = 3.0;      // pixels

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

bool touches(const Line& line, const Box& box) {
    const std::vector<Point> points = stepped(line.first, line.second);
    return std::any_of(points.begin(), points.end(), [&box](const Point& point) { return box.holds(point); });
}

bool cross(const Line& one, const Line& other) {
    const auto side = [](const Line& line, const Point& point) {
        return (line.second.x - line.first.x) * (point.y - line.first.y) -
                   (line.second.y - line.first.y) * (point.x - line.first.x) >
               0.0;
    };
    return side(one, other.first) != side(one, other.second) && side(other, one.first) != side(other, one.second);
}

/// The widest of gnuplot's numbers beside an axis from 0 to here, which it sets some four to twenty of.
double tick_width(double greatest) {
    const double power = std::pow(10.0, std::floor(std::log10(greatest))), first = greatest / power;
    const double step = power * (first < 2.0 ? 0.2 : first < 5.0 ? 0.5 : 1.0);
    constexpr double digit = 0.64;    // of the font size, DejaVu Sans
    double widest = 0.0;
    for (int i = 1; i * step <= greatest; ++i) {
        std::string number = fmt::format("{:g}", i * step);
        if (const std::size_t e = number.find('e'); e != std::string::npos) number.replace(e, std::string::npos, "×10^7");
        widest = std::max(widest, digit * Page::font * static_cast<double>(width_of(number)));
    }
    return widest;
}

double widest_tick(const Axis& axis) {
    if (axis.ticks.empty()) return tick_width(axis.greatest);
    double widest = 0.0;
    for (const Tick& tick : axis.ticks) widest = std::max(widest, text_width(tick.text, Page::font));
    return widest;
}

/// Where the plot begins: room for the y axis' numbers, and its label beside them.
double left_margin(const Figure& figure) {
    // [pixels] most pictures' numbers have three characters at most; given ticks may be any words
    constexpr double numbers = 16.0, label = 28.0, usual = 78.0, words = 10.0;
    const double taken = numbers + widest_tick(figure.y) + (figure.y.label.empty() ? 0.0 : label);
    return figure.y.ticks.empty() ? std::max(usual, taken) : taken + words;
}

/// What is beside the plot on the right, above it and below it.
double right_margin(const Figure& figure) {
    double widest = 12.0;
    for (const Guide& guide : figure.y.guides)
        widest = std::max(widest, Page::guide_gap + text_width(guide.text, Page::label_font));
    return widest + 6.0;
}

double top_margin(const Figure& figure) {
    return (figure.title.empty() ? 16.0 : 46.0) + (figure.x.guides.empty() ? 0.0 : Page::guide_line);
}

std::vector<std::string> note_lines(const Figure& figure) {
    const double letter = text_width("x", Page::label_font), room = figure.width - 2.0 * Page::note_margin;
    std::vector<std::string> lines;
    for (const std::string& note : figure.notes) {
        std::istringstream text(wrapped(note, 0, static_cast<std::size_t>(room / letter)));
        for (std::string line; std::getline(text, line);) lines.push_back(line);
    }
    return lines;
}

double height_of(const std::vector<std::string>& notes) {
    constexpr double gap = 8.0;
    return notes.empty() ? 0.0 : gap + Page::note_line * static_cast<double>(notes.size());
}

}    // namespace

Page::Page(const Figure& figure)
    : figure_(figure),
      notes_(note_lines(figure)),
      height_(figure.height + height_of(notes_)),
      plot_{left_margin(figure), top_margin(figure), figure.width - right_margin(figure), figure.height - 62.0} {
    trace_curves();
    for (std::size_t c = 0; c < figure.curves.size(); ++c) {
        if (!figure.curves[c].name.empty()) keyed_.push_back(c);
    }
    if (figure.curves.size() > 1 && !keyed_.empty()) place_key();
    if (key_ && cover(*key_) > 0.0) place_key_above();
    place_labels();
}

Point Page::pixel(const Point& point) const {
    return {std::lerp(plot_.left, plot_.right, figure_.x.share(point.x)),
            std::lerp(plot_.bottom, plot_.top, figure_.y.share(point.y))};
}

/// At the page's top, whatever lies between it and the plot; above the plot's middle as far as the page is wide enough.
Point Page::title() const {
    constexpr double edge = 8.0;
    const double half = text_width(figure_.title, font) / 2.0 + edge, middle = (plot_.left + plot_.right) / 2.0;
    return {half < width() - half ? std::clamp(middle, half, width() - half) : width() / 2.0, 0.5 * key_line + 8.0};
}

std::size_t Page::pixel_index(const Point& point) const {
    const auto column = static_cast<std::size_t>(std::clamp(point.x, 0.0, width() - 1.0));
    const auto row = static_cast<std::size_t>(std::clamp(point.y, 0.0, height_ - 1.0));
    return row * static_cast<std::size_t>(width()) + column;
}

Point Page::note(std::size_t line) const {
    return {note_margin, height_ - note_line * (static_cast<double>(notes_.size() - line) - 0.2)};
}

void Page::trace(const Point& from, const Point& to) {
    const std::vector<Point> piece = stepped(from, to);
    traces_.insert(traces_.end(), piece.begin(), piece.end());
}

void Page::trace_curves() {
    traces_.clear();
    markers_.clear();
    for (const Curve& curve : figure_.curves) {
        for (std::size_t i = 1; i < curve.points.size(); ++i) {
            const Point from = pixel(curve.points[i - 1]), to = pixel(curve.points[i]);
            if (std::isfinite(from.x + from.y + to.x + to.y)) trace(from, to);
        }
        for (const Mark& mark : curve.marks) markers_.push_back(pixel(mark.at));
    }
    inked_.assign(static_cast<std::size_t>(width() * height_), false);
    for (const Point& point : traces_) {
        for (const double x : {-1.0, 0.0, 1.0}) {
            for (const double y : {-1.0, 0.0, 1.0}) inked_[pixel_index({point.x + x, point.y + y})] = true;
        }
    }
    // A leader may cross these; a label had better not lie on them.
    for (const Curve& curve : figure_.curves) {
        for (const Mark& mark : curve.marks) {
            if (mark.reach) trace(pixel({mark.reach->first, mark.at.y}), pixel({mark.reach->second, mark.at.y}));
        }
    }
    for (const Guide& guide : figure_.x.guides) trace(pixel({guide.at, figure_.y.least}), pixel({guide.at, figure_.y.greatest}));
    for (const Guide& guide : figure_.y.guides) trace(pixel({figure_.x.least, guide.at}), pixel({figure_.x.greatest, guide.at}));
}

double Page::cover(const Box& box) const {
    const Box near = grown(box, 2.0);
    const auto under = [&near](const Point& point) { return near.holds(point); };
    return trace_step * static_cast<double>(std::count_if(traces_.begin(), traces_.end(), under)) +
           30.0 * static_cast<double>(std::count_if(markers_.begin(), markers_.end(), under));
}

/// The key's box with its entries in columns, read down.
void Page::fill_key(double left, double top, std::size_t columns) {
    double longest = 0.0;
    for (const std::size_t curve : keyed_) longest = std::max(longest, text_width(figure_.curves[curve].name, font));
    key_column_ = key_sample + longest + (columns > 1 ? 20.0 : 8.0);
    key_rows_ = (keyed_.size() + columns - 1) / columns;
    key_ = {left, top, left + key_column_ * static_cast<double>(columns),
            top + key_line * static_cast<double>(key_rows_) + 2.0 * key_edge};
}

Point Page::key_entry(std::size_t entry) const {
    return {key_->left + key_column_ * static_cast<double>(entry / key_rows_),
            key_->top + key_edge + key_line * (static_cast<double>(entry % key_rows_) + 0.5)};
}

/// Where no place among the curves is free, the plot gives up some of its height.
void Page::place_key_above() {
    fill_key(0.0, 0.0, 2);
    const double room = width() - plot_.left;
    const double guides = figure_.x.guides.empty() ? 0.0 : guide_line;
    const auto columns = static_cast<std::size_t>(std::clamp(room / key_column_, 1.0, 3.0));
    fill_key(plot_.left, plot_.top - guides - 8.0, columns);
    plot_.top = key_->bottom + guides + 4.0;
    trace_curves();
}

void Page::place_key() {
    fill_key(0.0, 0.0, 1);
    const double key_width = key_->right, key_height = key_->bottom;
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

double Page::crossings(const Line& leader) const {
    constexpr double beside_marker = 6.0;    // pixels in which a leader may touch the curve that it belongs to
    double crossed = 0.0;
    for (const Point& point : stepped(leader.first, leader.second)) {
        const bool away = std::hypot(point.x - leader.first.x, point.y - leader.first.y) > beside_marker;
        if (away && inked_[pixel_index(point)]) crossed += 1.0;
    }
    return crossed;
}

double Page::crowding(const PlacedLabel& label, const PlacedLabel& itself) const {
    double cost = 0.0;
    for (const PlacedLabel& other : labels_) {
        if (&other == &itself) continue;
        if (label.box.meets(grown(other.box, 2.0))) cost += 1000.0;
        if (label.leader && touches(*label.leader, other.box)) cost += 300.0;
        if (other.leader && touches(*other.leader, label.box)) cost += 300.0;
        if (label.leader && other.leader && cross(*label.leader, *other.leader)) cost += 150.0;
    }
    return cost;
}

double Page::find_place(PlacedLabel& label) const {
    constexpr double far_apart = 14.0;    // pixels from which a leader shows where a label belongs
    const double label_width = text_width(label.text, label_font) + 4.0, label_height = 1.25 * label_font;
    double best = std::numeric_limits<double>::infinity();
    PlacedLabel tried = label;
    for (const double distance : {7.0, 12.0, 20.0, 30.0, 44.0, 60.0, 80.0, 110.0}) {
        for (int direction = 0; direction < 16; ++direction) {
            const double angle = std::numbers::pi * direction / 8.0;
            tried.box = box_beside(label.anchor, angle, distance, label_width, label_height);
            if (!tried.box.lies_in(grown(plot_, -3.0)) || (key_ && tried.box.meets(*key_))) continue;
            tried.leader.reset();
            if (distance > far_apart) tried.leader = std::pair{label.anchor, nearest(tried.box, label.anchor)};
            double cost = 8.0 * cover(tried.box) + distance + 2.0 * std::abs(std::sin(angle / 2.0)) + crowding(tried, label);
            if (tried.leader) cost += 10.0 * crossings(*tried.leader);
            if (cost >= best) continue;
            best = cost;
            label.box = tried.box;
            label.leader = tried.leader;
        }
    }
    return best;
}

double Page::settle_labels() {
    constexpr int sweeps = 3;    // a label may make room for one that is placed after it
    double cost = 0.0;
    for (int sweep = 0; sweep < sweeps; ++sweep) {
        cost = 0.0;
        for (PlacedLabel& label : labels_) cost += find_place(label);
    }
    return cost;
}

void Page::place_labels() {
    for (std::size_t c = 0; c < figure_.curves.size(); ++c) {
        for (const Mark& mark : figure_.curves[c].marks) {
            if (mark.text.empty()) continue;
            const Point anchor = pixel(mark.at);
            labels_.push_back(
                {mark.text, mark.shared ? std::nullopt : std::optional(c), anchor, {anchor.x, anchor.y, anchor.x, anchor.y}, {}});
        }
    }
    // Whoever comes first takes the best place, so both orders are tried.
    const std::vector<PlacedLabel> unplaced = labels_;
    const double forward = settle_labels();
    std::vector<PlacedLabel> placed = std::exchange(labels_, {unplaced.rbegin(), unplaced.rend()});
    if (forward <= settle_labels()) labels_ = std::move(placed);
    std::erase_if(labels_,
                  [](const PlacedLabel& label) { return label.box.left == label.box.right; });    // wider than the picture
}

}    // namespace stylet::app
