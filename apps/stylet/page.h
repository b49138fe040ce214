// Where key and labels lie, so that they cover as little of the curves as can be.
#pragma once

#include "apps/stylet/figure.h"

#include <optional>
#include <vector>

namespace stylet::app {

/// Pixels of the picture, y downward.
struct Box {
    double left, top, right, bottom;

    [[nodiscard]] bool meets(const Box& other) const {
        return left < other.right && other.left < right && top < other.bottom && other.top < bottom;
    }
    [[nodiscard]] bool holds(const Point& point) const {
        return left <= point.x && point.x <= right && top <= point.y && point.y <= bottom;
    }
    [[nodiscard]] bool lies_in(const Box& other) const {
        return left >= other.left && right <= other.right && top >= other.top && bottom <= other.bottom;
    }
};

/// A label's place; `leader` runs from the marker to the label where they are apart.
struct PlacedLabel {
    std::string text;
    std::optional<std::size_t> curve;    // none: several curves share it
    Point anchor;                        // its marker
    Box box;
    std::optional<std::pair<Point, Point>> leader;
};

class Page {
public:
    static constexpr double font_points = 12.0, label_font_points = 10.5;
    static constexpr double pixels_per_point = 96.0 / 72.0;
    static constexpr double font = font_points * pixels_per_point, label_font = label_font_points * pixels_per_point;

    explicit Page(const Figure& figure);

    [[nodiscard]] double width() const { return figure_.width; }
    [[nodiscard]] double height() const { return height_; }
    [[nodiscard]] Point title() const;                                                // its middle
    [[nodiscard]] const Box& plot() const { return plot_; }                           // the axes' rectangle
    [[nodiscard]] const std::optional<Box>& key() const { return key_; }              // none for a single curve
    [[nodiscard]] const std::vector<std::size_t>& keyed() const { return keyed_; }    // the curves that it names
    [[nodiscard]] Point key_entry(std::size_t entry) const;    // left end of its sample, at half its height
    [[nodiscard]] const std::vector<PlacedLabel>& labels() const { return labels_; }
    [[nodiscard]] const std::vector<std::string>& notes() const { return notes_; }    // lines
    [[nodiscard]] Point note(std::size_t line) const;                                 // its left end, at half its height
    [[nodiscard]] Point pixel(const Point& point) const;

    static constexpr double key_line = 1.35 * font;     // height of one entry
    static constexpr double key_sample = 3.2 * font;    // width of its piece of line with the gap to the text

    static constexpr double guide_gap = 6.0;                  // between the plot and a guide's text beside it
    static constexpr double guide_line = 1.3 * label_font;    // height of those above it
    static constexpr double note_line = 1.35 * label_font, note_margin = 16.0;

private:
    void trace(const Point& from, const Point& to);
    void trace_curves();
    [[nodiscard]] std::size_t pixel_index(const Point& point) const;
    void place_key();
    void place_key_above();
    void fill_key(double left, double top, std::size_t columns);
    void place_labels();
    double settle_labels();                         // returns what the places cost
    double find_place(PlacedLabel& label) const;    // the best there is beside the other labels as they lie; returns its cost
    [[nodiscard]] double crossings(const std::pair<Point, Point>& leader) const;    // steps of it that lie on a curve
    [[nodiscard]] double crowding(const PlacedLabel& label, const PlacedLabel& itself) const;
    [[nodiscard]] double cover(const Box& box) const;    // length of curve under it, in pixels

    const Figure& figure_;
    std::vector<std::string> notes_;
    double height_;    // [pixels]
    Box plot_;
    std::vector<std::size_t> keyed_;
    std::vector<Point> traces_;    // points along all that is drawn, one a few pixels from the next
    std::vector<bool> inked_;      // pixels, row by row, that a curve covers
    std::vector<Point> markers_;
    std::optional<Box> key_;
    std::size_t key_rows_ = 0;
    double key_column_ = 0.0;    // [pixels] width of its columns
    std::vector<PlacedLabel> labels_;
};

}    // namespace stylet::app
