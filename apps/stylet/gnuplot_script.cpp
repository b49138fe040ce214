#include "apps/stylet/gnuplot.h"
#include "apps/stylet/page.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>

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

const Style& style(std::size_t curve) {
    return styles[curve % styles.size()];
}

/// An open marker, so that what lies below shows; another for each curve.
int marker(std::size_t curve) {
    constexpr std::array open{6, 4, 8, 10, 12};    // gnuplot's circle, square, triangles, diamond
    return open[curve % open.size()];
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

class Script {
public:
    explicit Script(const Figure& figure) : figure_(figure), page_(figure) {}

    std::string text() {
        add_data();
        add_axes();
        add_key();
        add_labels();
        // Fonts are in points: cairo knows them, SVG counts in pixels.
        add("set terminal svg size {},{} fixed enhanced font 'DejaVu Sans,{}' fontscale {} background rgb 'white'", Page::width,
            Page::height, Page::font_points, Page::pixels_per_point);
        add("set output 'figure.svg'");
        add_plot();
        add("set terminal pngcairo size {},{} enhanced font 'DejaVu Sans,{}' fontscale 2 linewidth 2 pointscale 2 background rgb "
            "'white'",
            2 * Page::width, 2 * Page::height, Page::font_points);
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

    static std::string screen(const Point& pixel) {
        return fmt::format("screen {:.5f}, screen {:.5f}", pixel.x / Page::width, 1.0 - pixel.y / Page::height);
    }

    void add_data() {
        for (std::size_t c = 0; c < figure_.curves.size(); ++c) {
            add("$curve{} << END", c);
            for (const Point& point : figure_.curves[c].points) add("{} {}", point.x, point.y);
            add("END\n$marks{} << END", c);
            for (const Mark& mark : figure_.curves[c].marks) add("{} {}", mark.at.x, mark.at.y);
            add("END");
        }
    }

    void add_axes() {
        const Box& plot = page_.plot();
        add("set encoding utf8");
        add("set lmargin at screen {:.5f}\nset rmargin at screen {:.5f}", plot.left / Page::width, plot.right / Page::width);
        add("set bmargin at screen {:.5f}\nset tmargin at screen {:.5f}", 1.0 - plot.bottom / Page::height,
            1.0 - plot.top / Page::height);
        add("set xrange [{}:{}]\nset yrange [{}:{}]", figure_.least.x, figure_.greatest.x, figure_.least.y, figure_.greatest.y);
        add("set border 3 lw 1 lc rgb '#404040'");
        add("set xtics nomirror out textcolor rgb 'black'\nset ytics nomirror out textcolor rgb 'black'");
        add("set grid lt 1 dt solid lw 0.5 lc rgb '#DDDDDD'");
        add("set xlabel {} noenhanced offset 0,0.2\nset ylabel {} noenhanced offset 1.2,0", quoted(figure_.x_label),
            quoted(figure_.y_label));
        if (!figure_.title.empty())    // at the page's top, whatever lies between it and the plot
            add("set label {} at {} center noenhanced", quoted(figure_.title),
                screen({(plot.left + plot.right) / 2.0, 0.5 * Page::key_line + 8.0}));
        add("unset key");
    }

    /// Drawn by hand, for gnuplot's own key knows neither the curves below it nor where labels will go.
    void add_key() {
        if (!page_.key()) return;
        const Box& key = *page_.key();
        add("set object 1 rectangle from {} to {} front fs solid 0.9 noborder fc rgb 'white'", screen({key.left, key.bottom}),
            screen({key.right, key.top}));
        for (std::size_t c = 0; c < figure_.curves.size(); ++c) {
            const Point entry = page_.key_entry(c);
            add_sample(c, entry.x, entry.x + Page::key_sample - 8.0, entry.y);
            add("set label {} at {} left noenhanced front", quoted(figure_.curves[c].name),
                screen({entry.x + Page::key_sample, entry.y}));
        }
    }

    /// A piece of the curve for the key, between two pixels.
    void add_sample(std::size_t c, double left, double right, double y) {
        if (figure_.curves[c].dotted) {
            add("set label '' at {} point pt {} ps 1 lw 1.5 lc rgb '{}' front", screen({(left + right) / 2.0, y}), marker(c),
                style(c).colour);
        } else {
            add("set arrow from {} to {} nohead front lw 2 lc rgb '{}' dt {}", screen({left, y}), screen({right, y}),
                style(c).colour, style(c).dashes);
        }
    }

    void add_labels() {
        for (const PlacedLabel& label : page_.labels()) {
            if (label.leader) {
                add("set arrow from {} to {} nohead lw 0.7 lc rgb '#808080'", screen(label.leader->first),
                    screen(label.leader->second));
            }
            add("set label {} at {} center noenhanced front font ',{}' textcolor rgb '{}'", quoted(label.text),
                screen({(label.box.left + label.box.right) / 2.0, (label.box.top + label.box.bottom) / 2.0}),
                Page::label_font_points, label.curve ? style(*label.curve).colour : shared_colour);
        }
    }

    void add_plot() {
        text_ += "plot ";
        for (std::size_t c = 0; c < figure_.curves.size(); ++c) {
            const std::string look = figure_.curves[c].dotted
                                         ? fmt::format("points pt {} ps 1 lw 1.5 lc rgb '{}'", marker(c), style(c).colour)
                                         : fmt::format("lines lw 2 lc rgb '{}' dt {}", style(c).colour, style(c).dashes);
            fmt::format_to(std::back_inserter(text_), "{}$curve{} with {}", c == 0 ? "" : ", ", c, look);
        }
        for (std::size_t c = 0; c < figure_.curves.size(); ++c) {
            if (figure_.curves[c].marks.empty()) continue;
            fmt::format_to(std::back_inserter(text_),
                           ", $marks{0} with points pt 7 ps 1.0 lc rgb 'white', $marks{0} with points pt 7 ps 0.7 lc rgb '{1}'",
                           c, style(c).colour);
        }
        text_ += '\n';
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
