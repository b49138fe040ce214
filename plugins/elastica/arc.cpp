#include "arc.h"

#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/ellint_2.hpp>
#include <boost/math/special_functions/jacobi_elliptic.hpp>

#include <cmath>
#include <numbers>

namespace stylet::elastica {

namespace {

using boost::math::ellint_1;
using boost::math::ellint_2;
using std::numbers::pi;

struct Jacobi {
    double sn, cn, E;    // E(am u)
};

Jacobi jacobi(double k, double quarter, double u) {
    Jacobi at{};
    double dn = 0.0;
    at.sn = boost::math::jacobi_elliptic(k, u, &at.cn, &dn);
    const double within = std::atan2(at.sn, at.cn);    // am u, but for whole turns: it is never π from πu/2K
    at.E = ellint_2(k, within + 2.0 * pi * std::round((0.5 * pi * u / quarter - within) / (2.0 * pi)));
    return at;
}

double first_of(Ends ends, double quarter, double length) {
    switch (ends) {
        case Ends::pinned_pinned:
            return quarter;
        case Ends::clamped_pinned:
            return 3.0 * quarter - length;
        default:
            return 0.0;
    }
}

}    // namespace

Arc::Arc(Ends ends, double modulus, double length)
    : ends_(ends), modulus_(modulus), quarter_(ellint_1(modulus)), length_(length), first_(first_of(ends, quarter_, length)) {
    const Jacobi first = jacobi(modulus_, quarter_, first_);
    turn_ = ends == Ends::clamped_pinned ? 2.0 * std::asin(modulus_ * first.sn) : 0.0;
    first_cn_ = first.cn;
    first_E_ = first.E;
}

double Arc::misfit() const {
    switch (ends_) {
        case Ends::clamped_free:
            return quarter_ - length_;
        case Ends::pinned_pinned:
            return 2.0 * quarter_ - length_;
        case Ends::clamped_clamped:
            return 4.0 * quarter_ - length_;
        case Ends::clamped_pinned:
            break;
    }
    return at(1.0).aside / modulus_;
}

BowPoint Arc::at(double arc) const {
    const Jacobi here = jacobi(modulus_, quarter_, first_ + length_ * arc);
    const double X = 2.0 * (here.E - first_E_) / length_ - arc;
    const double Y = -2.0 * modulus_ * (here.cn - first_cn_) / length_;
    return {.along = X * std::cos(turn_) + Y * std::sin(turn_),
            .aside = Y * std::cos(turn_) - X * std::sin(turn_),
            .tangent = 2.0 * std::asin(modulus_ * here.sn) - turn_};
}

double Arc::load() const {
    return length_ * length_ * std::cos(turn_);
}

double Arc::energy() const {    // φ' = 2kλ cn u, with ∫ k² cn² du = E − (1 − k²)u
    const double E = jacobi(modulus_, quarter_, first_ + length_).E - first_E_;
    return 2.0 * length_ * (E - (1.0 - modulus_ * modulus_) * length_);
}

double Arc::deflection() const {
    if (ends_ == Ends::clamped_free) return at(1.0).aside;
    if (ends_ != Ends::clamped_pinned) return at(0.5).aside;
    return at(2.0 - 4.0 * quarter_ / length_).aside;    // where φ is ψ again: at u = 2K − u₀
}

double Arc::largest_slope() const {    // of a clamped-pinned one at its pin, where φ = −α
    return 2.0 * std::asin(modulus_) + turn_;
}

}    // namespace stylet::elastica
