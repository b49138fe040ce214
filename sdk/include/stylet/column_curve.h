// How a buckled column carries load and which shape it has, without dimensions.
#pragma once

#include <stylet/hermite_table.h>

#include <utility>

namespace stylet {

/// Everything about a bowed column's load at one shortening η = δ/L.
struct CurvePoint {
    double load;      // f = N/P_cr
    double slope;     // df/dη
    double energy;    // ∫₀^η f dη
};

/// A place on a bowed column of unit length.
struct BowPoint {
    double along;      // the straight line, from the base
    double aside;      // of it, toward the bow
    double tangent;    // [rad] to the line, positive toward the bow
};

/// A column that has buckled, of unit length and unit critical load. Its load is a table over the shortening; where that ends,
/// the column is folded and stops: it can hardly get shorter, whatever the load.
class ColumnCurve {
public:
    explicit ColumnCurve(HermiteTable load) : load_(std::move(load)) {}
    ColumnCurve(const ColumnCurve&) = delete;
    ColumnCurve& operator=(const ColumnCurve&) = delete;
    virtual ~ColumnCurve() = default;

    /// 0 ≤ η.
    [[nodiscard]] CurvePoint at(double shortening) const {
        const double over = shortening - folded();
        if (over < 0.0) return {load_.value(shortening), load_.slope(shortening), load_.integral(shortening)};
        const double last = load_.value(folded());
        return {last + stop * over, stop, load_.integral(folded()) + (last + 0.5 * stop * over) * over};
    }

    /// The shortening at which the column stops.
    [[nodiscard]] double folded() const { return load_.end(); }

    /// k of P_cr = k EI/L² where the scene names no model of the critical load; infinite: the column then never buckles.
    [[nodiscard]] virtual double own_factor() const = 0;

    /// 0 ≤ arc ≤ 1 from the base.
    [[nodiscard]] virtual BowPoint bow(double shortening, double arc) const = 0;

    /// Largest distance from the straight line, and largest angle to it [rad].
    [[nodiscard]] virtual double deflection(double shortening) const = 0;
    [[nodiscard]] virtual double largest_slope(double shortening) const = 0;

    /// How far off the line the far end is: nothing where it is held on it.
    [[nodiscard]] virtual double end_aside(double /*shortening*/) const { return 0.0; }

private:
    static constexpr double stop = 1e3;    // df/dη of a folded column

    HermiteTable load_;
};

}    // namespace stylet
