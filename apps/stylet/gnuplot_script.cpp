#include "apps/stylet/gnuplot.h"
#include "apps/stylet/page.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <string>
#include <vector>

namespace stylet::app {
namespace {

/// Okabe and Ito 2008: told apart by all kinds of colour vision. The dashes (in pixels) tell them apart in black and white.
struct Style {
    const char* colour;
    const char* dashes;
};
constexpr std::array styles{Style{"#0072B2", "solid"},         Style{"#D55E00", "(14,5)"}, Style{"#009E73", "(3,4)"},
                            Style{"#CC79A7", "(14,4,3,4)"},    Style{"#E69F00", "(7,4)"},  Style{"#000000", "(20,5)"},
                            Style{"#56B4E9", "(14,4,3,4,3,4)"}};

constexpr const char* shared_colour = "#303030";    // of a label that belongs to several curves
constexpr const char* band_colour = "#DDDDDD";
constexpr const char* grey = "#707070";

const Style& style(std::size_t curve) {
    return styles[curve % styles.size()];
}

/// Open, so that what lies below shows, and filled; another for each curve.
struct Marker {
    int open, filled;
};
const Marker& marker(std::size_t curve) {
    // gnuplot's circle, square, triangles, diamond
    static constexpr std::array markers{Marker{6, 7}, Marker{4, 5}, Marker{8, 9}, Marker{10, 11}, Marker{12, 13}};
    return markers[curve % markers.size()];
}

/// Single quotes keep gnuplot from expanding anything; only the quote itself must be doubled.
std::string quoted(const std::string& text) {
    std::string result = "'";
    for (const char letter : text) {
        if (letter == '\'')
            result += "''";
        else
            result += static_cast<unsigned char>(letter) < ' ' ? ' ' : letter;
    }
    return result + "'";
}

/// What is written beside an axis is a format to gnuplot.
std::string as_format(const std::string& text) {
    std::string result;
    for (const char letter : text) result += letter == '%' ? std::string("%%") : std::string(1, letter);
    return result;
}

/// In pixels of the picture, y downward.
Point direction_of(Beyond beyond) {
    switch (beyond) {
        case Beyond::below:
            return {0.0, 1.0};
        case Beyond::above:
            return {0.0, -1.0};
        case Beyond::left:
            return {-1.0, 0.0};
        case Beyond::right:
            return {1.0, 0.0};
        case Beyond::none:
            break;
    }
    return {0.0, 0.0};
}

class Script {
public:
    explicit Script(const Figure& figure) : figure_(figure), page_(figure) {}

    std::string text() {
        add_data();
        add_axes();
        add_key();
        add_labels();
        add_arrows();
        // Fonts are in points: cairo knows them, SVG counts in pixels.
        add("set terminal svg size {},{} fixed enhanced font 'DejaVu Sans,{}' fontscale {} background rgb 'white'", page_.width(),
            page_.height(), Page::font_points, Page::pixels_per_point);
        add("set output 'figure.svg'");
        add_plot();
        add("set terminal pngcairo size {},{} enhanced font 'DejaVu Sans,{}' fontscale 2 linewidth 2 pointscale 2 background rgb "
            "'white'",
            2 * page_.width(), 2 * page_.height(), Page::font_points);
        add("set output 'figure.png'");
        add_plot();
        add("unset output");
        return std::move(text_);
    }

private:
    template <class... Values>
    void add(fmt::format_string<Values...> format, Values&&... values) {
        fmt::format_to(std::back_inserter(text_), format, std::forward<Values>(values)...);
        text_ += '\n';
    }

    [[nodiscard]] std::string screen(const Point& pixel) const {
        return fmt::format("screen {:.5f}, screen {:.5f}", pixel.x / page_.width(), 1.0 - pixel.y / page_.height());
    }

    [[nodiscard]] const char* colour(std::size_t c) const { return figure_.curves[c].grey ? grey : style(c).colour; }

    void add_data() {
        for (std::size_t c = 0; c < figure_.curves.size(); ++c) {
            const Curve& curve = figure_.curves[c];
            add("$curve{} << END", c);
            for (const Point& point : curve.points) {
                if (std::isfinite(point.x) && std::isfinite(point.y))
                    add("{} {}", point.x, point.y);
                else
                    add("");
            }
            add("END\n$marks{} << END", c);
            for (const Mark& mark : curve.marks)
                add("{} {} {}", mark.at.x, mark.at.y, mark.filled ? marker(c).filled : marker(c).open);
            add("END\n$reaches{} << END", c);
            for (const Mark& mark : curve.marks) {
                if (mark.reach) add("{} {} {} {}", mark.at.x, mark.at.y, mark.reach->first, mark.reach->second);
            }
            add("END");
        }
    }

    void add_axes() {
        const Box& plot = page_.plot();
        add("set encoding utf8");
        add("set lmargin at screen {:.5f}\nset rmargin at screen {:.5f}", plot.left / page_.width(), plot.right / page_.width());
        add("set bmargin at screen {:.5f}\nset tmargin at screen {:.5f}", 1.0 - plot.bottom / page_.height(),
            1.0 - plot.top / page_.height());
        add("set border 3 lw 1 lc rgb '#404040'");
        add_axis("x", figure_.x, "0,0.2");
        add_axis("y", figure_.y, "1.2,0");
        add("set grid lt 1 dt solid lw 0.5 lc rgb '#DDDDDD'");
        if (!figure_.title.empty()) add("set label {} at {} center noenhanced", quoted(figure_.title), screen(page_.title()));
        add("unset key");
        add_guides();
        for (std::size_t line = 0; line < page_.notes().size(); ++line) {
            add("set label {} at {} left noenhanced font ',{}' textcolor rgb '{}'", quoted(page_.notes()[line]),
                screen(page_.note(line)), Page::label_font_points, grey);
        }
    }

    void add_axis(const char* name, const Axis& axis, const char* label_offset) {
        add("set {}range [{}:{}]", name, axis.least, axis.greatest);
        if (axis.scale == Scale::logarithmic) add("set logscale {}", name);
        std::string ticks;
        for (const Tick& tick : axis.ticks)
            ticks +=
                fmt::format("{}{} {} {:d}", ticks.empty() ? "" : ", ", quoted(as_format(tick.text)), tick.at, tick.text.empty());
        // gnuplot writes its own powers of ten with markup.
        add("set {}tics nomirror out textcolor rgb 'black'{}", name, ticks.empty() ? "" : fmt::format(" noenhanced ({})", ticks));
        add("set {}label {} noenhanced offset {}", name, quoted(axis.label), label_offset);
    }

    void add_guides() {
        const Box& plot = page_.plot();
        const auto add_guide = [&](const Point& from, const Point& to, const Guide& guide, const Point& text, const char* side) {
            add("set arrow from {} to {} nohead back lw 1.2 lc rgb '{}' dt (6,4)", screen(from), screen(to), grey);
            add("set label {} at {} {} noenhanced font ',{}' textcolor rgb '{}'", quoted(guide.text), screen(text), side,
                Page::label_font_points, grey);
        };
        for (const Guide& guide : figure_.x.guides) {
            const double x = page_.pixel({guide.at, figure_.y.least}).x;
            add_guide({x, plot.bottom}, {x, plot.top}, guide, {x, plot.top - Page::guide_line / 2.0}, "center");
        }
        for (const Guide& guide : figure_.y.guides) {
            const double y = page_.pixel({figure_.x.least, guide.at}).y;
            add_guide({plot.left, y}, {plot.right, y}, guide, {plot.right + Page::guide_gap, y}, "left");
        }
    }

    /// Drawn by hand, for gnuplot's own key knows neither the curves below it nor where labels will go.
    void add_key() {
        if (!page_.key()) return;
        const Box& key = *page_.key();
        add("set object 1 rectangle from {} to {} front fs solid 0.9 noborder fc rgb 'white'", screen({key.left, key.bottom}),
            screen({key.right, key.top}));
        for (std::size_t i = 0; i < page_.keyed().size(); ++i) {
            const std::size_t c = page_.keyed()[i];
            const Point entry = page_.key_entry(i);
            add_sample(c, entry.x, entry.x + Page::key_sample - 8.0, entry.y);
            add("set label {} at {} left noenhanced front", quoted(figure_.curves[c].name),
                screen({entry.x + Page::key_sample, entry.y}));
        }
    }

    /// "lw 2 lc rgb '#0072B2' dt solid"
    [[nodiscard]] std::string line_of(std::size_t c) const {
        switch (figure_.curves[c].look) {
            case Look::band:
                return fmt::format("lw 7 lc rgb '{}' dt solid", band_colour);
            case Look::joined_marks:
                return fmt::format("lw 1 lc rgb '{}' dt solid", colour(c));
            default:
                return fmt::format("lw 2 lc rgb '{}' dt {}", colour(c), style(c).dashes);
        }
    }

    /// A piece of the curve for the key, between two pixels.
    void add_sample(std::size_t c, double left, double right, double y) {
        const Look look = figure_.curves[c].look;
        if (look != Look::dots) add("set arrow from {} to {} nohead front {}", screen({left, y}), screen({right, y}), line_of(c));
        if (look == Look::dots || look == Look::joined_marks)
            add("set label '' at {} point pt {} ps 1 lw 1.5 lc rgb '{}' front", screen({(left + right) / 2.0, y}),
                look == Look::dots ? marker(c).open : marker(c).filled, colour(c));
    }

    void add_labels() {
        for (const PlacedLabel& label : page_.labels()) {
            if (label.leader) {
                add("set arrow from {} to {} nohead lw 0.7 lc rgb '#808080'", screen(label.leader->first),
                    screen(label.leader->second));
            }
            add("set label {} at {} center noenhanced front font ',{}' textcolor rgb '{}'", quoted(label.text),
                screen({(label.box.left + label.box.right) / 2.0, (label.box.top + label.box.bottom) / 2.0}),
                Page::label_font_points, label.curve ? colour(*label.curve) : shared_colour);
        }
    }

    /// Arrows from markers that stand for a value outside of the axes.
    void add_arrows() {
        for (std::size_t c = 0; c < figure_.curves.size(); ++c) {
            for (const Mark& mark : figure_.curves[c].marks) {
                if (mark.beyond != Beyond::none) add_arrow(page_.pixel(mark.at), direction_of(mark.beyond), c);
            }
        }
    }

    void add_arrow(const Point& from, const Point& direction, std::size_t c) {
        const auto away = [&](double pixels) { return screen({from.x + pixels * direction.x, from.y + pixels * direction.y}); };
        constexpr double marker_edge = 5.0, end = 15.0;    // [pixels]
        add("set arrow from {} to {} head filled size screen 0.006,20 front lw 1 lc rgb '{}'", away(marker_edge), away(end),
            colour(c));
    }

    void add_plot() {
        std::vector<std::string> layers;
        for (const bool band : {true, false}) {
            for (std::size_t c = 0; c < figure_.curves.size(); ++c) {
                const Look look = figure_.curves[c].look;
                if (figure_.curves[c].points.empty() || (look == Look::band) != band) continue;
                layers.push_back(look == Look::dots ? fmt::format("$curve{} with points pt {} ps 1 lw 1.5 lc rgb '{}'", c,
                                                                  marker(c).open, colour(c))
                                                    : fmt::format("$curve{} with lines {}", c, line_of(c)));
            }
        }
        for (std::size_t c = 0; c < figure_.curves.size(); ++c) {
            if (!figure_.curves[c].marks.empty()) add_marks(c, layers);
        }
        if (layers.empty()) layers.emplace_back("NaN");    // the axes alone
        add("plot {}", fmt::join(layers, ", "));
    }

    void add_marks(std::size_t c, std::vector<std::string>& layers) const {
        const Curve& curve = figure_.curves[c];
        if (curve.look != Look::joined_marks) {
            layers.push_back(fmt::format("$marks{} with points pt 7 ps 1.0 lc rgb 'white'", c));
            layers.push_back(fmt::format("$marks{} with points pt 7 ps 0.7 lc rgb '{}'", c, colour(c)));
            return;
        }
        if (std::ranges::any_of(curve.marks, [](const Mark& mark) { return mark.reach.has_value(); }))
            layers.push_back(fmt::format("$reaches{} using 1:2:3:4 with xerrorbars ps 0 lw 0.7 lc rgb '{}'", c, colour(c)));
        // White below, so that no line runs through an open marker.
        layers.push_back(fmt::format("$marks{} using 1:2 with points pt {} ps 1 lc rgb 'white'", c, marker(c).filled));
        layers.push_back(fmt::format("$marks{} using 1:2:3 with points pt variable ps 1 lw 1.5 lc rgb '{}'", c, colour(c)));
    }

    const Figure& figure_;
    Page page_;
    std::string text_;
};

}    // namespace

std::string gnuplot_script(const Figure& figure) {
    return Script(figure).text();
}

}    // namespace stylet::app
