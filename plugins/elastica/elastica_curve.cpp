#include "elastica_curve.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace stylet::elastica {

namespace {

using std::numbers::pi;
using Knot = HermiteTable::Knot;

constexpr int pieces = 1000;    // the tables are within 1e-9 of the formulas (their test)

// λ of the straight column that is about to bow.
double straight_length(Ends ends) {
    constexpr double clamped_pinned = 4.493409457909064;    // the first positive root of tan x = x
    switch (ends) {
        case Ends::clamped_free:
            return 0.5 * pi;
        case Ends::pinned_pinned:
            return pi;
        case Ends::clamped_clamped:
            return 2.0 * pi;
        case Ends::clamped_pinned:
            break;
    }
    return clamped_pinned;
}

// The shortening of a column that is folded. A clamped-pinned one carries nothing at 0.812087: it stops just before, so that it
// springs open when it is let go. The others' ends are level.
double folded_shortening(Ends ends) {
    return ends == Ends::clamped_pinned ? 0.812 : 1.0;
}

// k² and λ of an arc.
using Unknowns = Eigen::Vector2d;

// η and misfit of an arc, then what is tabulated beside its unknowns: f, and the squares of its deflection and its largest slope,
// which are smooth at η = 0.
using Answers = Eigen::Vector<double, 5>;

Answers answers(Ends ends, const Unknowns& of) {
    const Arc arc(ends, std::sqrt(of[0]), of[1]);
    return {arc.shortening(), arc.misfit(), arc.load() / std::pow(straight_length(ends), 2), std::pow(arc.deflection(), 2),
            std::pow(arc.largest_slope(), 2)};
}

using Derivatives = Eigen::Matrix<double, 5, 2>;

// By central differences: off by their square times the third derivatives, and by 1e-16 over them of rounding.
Derivatives derivatives(Ends ends, const Unknowns& of) {
    constexpr double h = 1e-5;
    Derivatives result;
    for (int i = 0; i < 2; ++i) {
        const Unknowns nudge = h * Unknowns::Unit(i);
        result.col(i) = (answers(ends, of + nudge) - answers(ends, of - nudge)) / (2.0 * h);
    }
    return result;
}

// One row of the tables: k², λ, f, deflection², largest slope² and their slopes over η.
struct Entry {
    Eigen::Vector<double, 5> values, slopes;

    [[nodiscard]] Unknowns arc() const { return values.head<2>(); }
    [[nodiscard]] Knot knot(int column) const { return {values[column], slopes[column]}; }
};

// The arc of this shortening, by Newton from a guess.
Entry entry_at(Ends ends, double shortening, Unknowns arc) {
    constexpr double close = 1e-14;    // some roundings
    const Eigen::Matrix2d inverse = derivatives(ends, arc).topRows<2>().inverse();
    Answers now = answers(ends, arc);
    for (int newton = 0; newton < 50 && std::abs(now[0] - shortening) + std::abs(now[1]) > close; ++newton) {
        arc -= inverse * Unknowns(now[0] - shortening, now[1]);
        now = answers(ends, arc);
    }
    const Derivatives change = derivatives(ends, arc);
    const Unknowns slopes = change.topRows<2>().inverse().col(0);
    Entry entry;
    entry.values << arc, now.tail<3>();
    entry.slopes << slopes, change.bottomRows<3>() * slopes;
    return entry;
}

// The limit at η = 0, where k² = 0 too: its slopes are extrapolated from those close by.
Entry first_entry(Ends ends) {
    constexpr double near = 1e-4;
    const double straight = straight_length(ends);
    const Entry one = entry_at(ends, near, {near, straight}), two = entry_at(ends, 2.0 * near, {2.0 * near, straight});
    return {.values = {0.0, straight, 1.0, 0.0, 0.0}, .slopes = 2.0 * one.slopes - two.slopes};
}

}    // namespace

ElasticaCurve::ElasticaCurve(Ends ends) : ElasticaCurve(ends, tabulate(ends)) {}

ElasticaCurve::ElasticaCurve(Ends ends, Tables tables)
    : ColumnCurve(std::move(tables.load)),
      ends_(ends),
      square_(std::move(tables.square)),
      length_(std::move(tables.length)),
      deflection_(std::move(tables.deflection)),
      slope_(std::move(tables.slope)) {}

ElasticaCurve::Tables ElasticaCurve::tabulate(Ends ends) {
    const double step = folded_shortening(ends) / pieces;
    std::vector<Entry> entries{first_entry(ends)};
    for (int i = 1; i <= pieces; ++i) {
        const Entry& last = entries.back();
        entries.push_back(entry_at(ends, i * step, last.arc() + step * last.slopes.head<2>()));
    }
    const auto column = [&entries, step](int number) {
        std::vector<Knot> knots;
        for (const Entry& entry : entries) knots.push_back(entry.knot(number));
        return HermiteTable(step, std::move(knots));
    };
    return {.square = column(0), .length = column(1), .load = column(2), .deflection = column(3), .slope = column(4)};
}

Arc ElasticaCurve::arc(double shortening) const {
    return {ends_, std::sqrt(std::max(0.0, square_.value(shortening))), length_.value(shortening)};
}

double ElasticaCurve::deflection(double shortening) const {
    return std::sqrt(std::max(0.0, deflection_.value(shortening)));
}

double ElasticaCurve::largest_slope(double shortening) const {
    return std::sqrt(std::max(0.0, slope_.value(shortening)));
}

double ElasticaCurve::own_factor() const {
    return straight_length(ends_) * straight_length(ends_);
}

double ElasticaCurve::end_aside(double shortening) const {
    return ends_ == Ends::clamped_free ? deflection(shortening) : 0.0;
}

double ElasticaCurve::touches_itself() const {
    constexpr double clamped_clamped = 0.8488;    // where its bulge has come back to the base's level (its test)
    return ends_ == Ends::clamped_clamped ? clamped_clamped : folded();
}

const ElasticaCurve& ElasticaCurve::of(Ends ends) {
    switch (ends) {
        case Ends::clamped_free: {
            static const ElasticaCurve made(Ends::clamped_free);
            return made;
        }
        case Ends::pinned_pinned: {
            static const ElasticaCurve made(Ends::pinned_pinned);
            return made;
        }
        case Ends::clamped_clamped: {
            static const ElasticaCurve made(Ends::clamped_clamped);
            return made;
        }
        case Ends::clamped_pinned:
            break;
    }
    static const ElasticaCurve made(Ends::clamped_pinned);
    return made;
}

}    // namespace stylet::elastica
