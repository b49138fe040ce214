#include "beam_column.h"

#include <boost/math/special_functions/ellint_2.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace stylet::beam_column {

namespace {

using std::numbers::pi;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double greatest_slope = pi / 4.0;    // [rad] beyond it Eq. (4) is far from any real column

// Where along the span (0 to 1) a half sine with end slope `a` has the fraction `arc` of its length behind it: E(πx, k) =
// 2E(k)·arc.
double abscissa(double arc, double a) {
    const double k = std::sin(a), target = 2.0 * boost::math::ellint_2(k) * arc;
    double phase = pi * arc;
    for (int newton = 0; newton < 20; ++newton) {    // for drawing; converges in 3–5 below 60°
        const double rate = std::sqrt(1.0 - k * k * std::pow(std::sin(phase), 2));
        phase = std::clamp(phase - (boost::math::ellint_2(k, phase) - target) / rate, 0.0, pi);
    }
    return phase / pi;
}

}    // namespace

BeamColumn::BeamColumn(const Setup& setup)
    : needle_(*setup.needle),
      buckling_(setup.buckling),
      free_(3 * max_contacts),
      compliance_(3 * max_contacts, 3 * max_contacts) {
    set_free_length(needle_.length);
    state_ = trial_;
}

double BeamColumn::critical_load(double free_length) const {
    if (buckling_ == nullptr) return infinity;
    return buckling_->critical_load({.bending_stiffness = needle_.bending_stiffness(),
                                     .free_length = free_length,
                                     .inserted = std::max(0.0, needle_.length - free_length),
                                     .depth = depth(free_length),
                                     .radius = needle_.radius,
                                     .ends = needle_.ends});
}

double BeamColumn::depth(double free_length) const {
    return std::max(0.0, needle_.length - free_length) * std::abs(trial_.base.axis().z());
}

void BeamColumn::predict(const Pose& base, double free_length, double /*dt: no inertia*/) {
    trial_.base = base;
    set_free_length(free_length);
}

// A column shorter than the needle is thick is none: its length stays at the radius.
void BeamColumn::set_free_length(double free_length) {
    const double length = std::max(free_length, needle_.radius);
    if (length == trial_.free_length && depth(length) == trial_.depth) return;
    trial_.free_length = length;
    trial_.depth = depth(length);
    trial_.critical_load = critical_load(length);
    if (buckling_ != nullptr) {
        const double h = 1e-4 * length;
        trial_.critical_slope = (critical_load(length + h) - critical_load(length - h)) / (2.0 * h);
    }
}

Linearisation BeamColumn::linearise(ContactPoints points, double /*shift: no inertia*/) {
    const auto count = static_cast<Eigen::Index>(points.size());
    const Vector3 axis = trial_.base.axis();
    double yielding = 0.0;    // [m/N] dδ/dN
    double shortening = trial_.shortening;
    if (trial_.bowed) {
        const CurvePoint now = curve_.at(trial_.shortening / trial_.free_length);
        yielding = trial_.free_length / (trial_.critical_load * now.slope);
        shortening -= trial_.critical_load * now.load * yielding;    // where the tangent would end without any load
    }
    const Matrix3 block = yielding * axis * axis.transpose();
    for (Eigen::Index i = 0; i < count; ++i) {
        free_.segment<3>(3 * i) = trial_.base.position + (points[i].arclength - shortening) * axis;
        for (Eigen::Index j = 0; j < count; ++j) compliance_.block<3, 3>(3 * j, 3 * i) = block;
    }
    return {.free = {free_.data(), 3 * count},
            .compliance = {compliance_.data(), 3 * count, 3 * count, Eigen::OuterStride<>(compliance_.outerStride())},
            .negatives = 0};
}

StepReport BeamColumn::try_step(ContactPoints points, Forces forces) {
    const Vector3 axis = trial_.base.axis();
    const double before = trial_.shortening;
    Vector3 sum = Vector3::Zero();
    for (std::size_t i = 0; i < points.size(); ++i) sum += forces.segment<3>(3 * static_cast<Eigen::Index>(i));
    trial_.compression = -sum.dot(axis);

    StepReport report;
    if (trial_.bowed) {    // along the tangent that linearise has just used
        const CurvePoint now = curve_.at(before / trial_.free_length);
        const double tangent = trial_.critical_load * now.slope / trial_.free_length;
        trial_.shortening = before + (trial_.compression - trial_.critical_load * now.load) / tangent;
        trial_.bowed = trial_.shortening > 0.0;
        report.tangent_changed = !trial_.bowed;
        if (trial_.bowed) {
            report.residual =
                std::abs(trial_.compression - trial_.critical_load * curve_.at(trial_.shortening / trial_.free_length).load);
        } else {
            trial_.shortening = 0.0;
        }
    } else if (trial_.compression > trial_.critical_load) {    // the straight branch is refused above the critical load
        trial_.bowed = true;
        report = {.residual = trial_.compression - trial_.critical_load, .tangent_changed = true};
    }

    trial_.wrench.force = -sum;
    trial_.wrench.moment.setZero();
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Vector3 arm = held_position(points[i].arclength) - trial_.base.position;
        trial_.wrench.moment -= arm.cross(forces.segment<3>(3 * static_cast<Eigen::Index>(i)));
    }
    return report;
}

double BeamColumn::stored(const State& state) const {
    if (!state.bowed) return 0.0;
    return state.critical_load * state.free_length * curve_.at(state.shortening / state.free_length).energy;
}

double BeamColumn::entry_force() const {
    if (!trial_.bowed) return 0.0;
    const double eta = trial_.shortening / trial_.free_length;
    const CurvePoint now = curve_.at(eta);
    return -trial_.critical_slope * trial_.free_length * now.energy - trial_.critical_load * (now.energy - eta * now.load);
}

NeedleState BeamColumn::state() const {
    const double slope = state_.bowed ? curve_.end_slope(state_.shortening / state_.free_length) : 0.0;
    return {.critical_load = state_.critical_load,
            .axial_load = state_.compression,
            .deflection = slope > 0.0 ? state_.free_length * ColumnCurve::amplitude(slope) : 0.0,
            .slope = slope,
            .buckled = state_.bowed};
}

const char* BeamColumn::beyond_validity() const {
    if (!state_.bowed || curve_.end_slope(state_.shortening / state_.free_length) <= greatest_slope) return nullptr;
    return "beyond validity: the needle's slope is over 45°";
}

// On the needle's line, as far from the base as the shortening leaves it.
Vector3 BeamColumn::straight(const State& state, double arclength) {
    return state.base.position + (arclength - state.shortening) * state.base.axis();
}

Vector3 BeamColumn::position(const State& state, double arclength) const {
    if (!state.bowed || arclength >= state.free_length) return straight(state, arclength);
    const Vector3 axis = state.base.axis();
    const double slope = curve_.end_slope(state.shortening / state.free_length);
    const double x = abscissa(std::max(0.0, arclength / state.free_length), slope);
    const double bow = state.free_length * ColumnCurve::amplitude(slope) * std::sin(pi * x);
    return state.base.position + x * (state.free_length - state.shortening) * axis + bow * state.base.bow_direction();
}

Vector3 BeamColumn::tangent(double arclength) const {
    Vector3 axis = trial_.base.axis();
    if (!trial_.bowed || arclength >= trial_.free_length) return axis;
    const double slope = curve_.end_slope(trial_.shortening / trial_.free_length);
    const double x = abscissa(std::max(0.0, arclength / trial_.free_length), slope);
    return (axis + std::tan(slope) * std::cos(pi * x) * trial_.base.bow_direction()).normalized();
}

void BeamColumn::centreline(std::span<Vector3> points) const {
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double arclength = needle_.length * static_cast<double>(i) / static_cast<double>(points.size() - 1);
        points[i] = position(state_, arclength);
    }
}

}    // namespace stylet::beam_column

STYLET_PLUGIN(
    stylet::beam_column::BeamColumn, "beam_column", stylet::no_parameters,
    .summary = "The paper's needle: straight up to its critical load, then a half sine; no limit load",
    .formula =
        "straight: d = 0, N <= P_cr(L)\n"
        "bowed:    d > 0, N = P_cr(L) f(d/L)\n"
        "stored:   U = P_cr(L) L (integral of f from 0 to d/L)\n"
        "d [m] shortening of the free length L [m], N [N] compression, P_cr from `buckling`, f from Eqs. (4) and (5)",
    .source =
        "He, Chen and Tang, section II.D, Eqs. (4) and (5); Bigoni et al. 2015 for the force at the mouth of the track. "
        "Deviation: the stored energy is the integral of the force over d, not the sine's bending energy",
    .validity =
        "End slope up to 45 degrees; a run says when it goes further. Without `buckling` the needle never buckles. Leaves out "
        "a limit load (a real clamped-pinned column carries at most 1.14 P_cr), bending by lateral forces, and inertia")
