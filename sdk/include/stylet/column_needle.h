// A needle that is a column with one generalised coordinate. Which column is said by its curve.
#pragma once

#include <stylet/buckling_model.h>
#include <stylet/column_curve.h>
#include <stylet/needle_model.h>

#include <algorithm>
#include <cmath>

namespace stylet {

/// One generalised coordinate, the shortening δ ≥ 0 [m] of the free length L:
///
///     δ = 0 and N ≤ P_cr(L),   or   δ > 0 and N = P_cr(L) f(δ/L),   U = P_cr(L) L ∫₀^(δ/L) f dη
///
/// with N the compression and f the curve's. P_cr is that of the scene's `buckling`, for the declared ends; without one the
/// curve's own, k EI/L². A free length below the needle's radius counts as the radius.
///
/// The inserted part is straight, stays on the needle's line and moves as one. Where the column's end is free, only the shape
/// that is drawn (position, tangent, centreline) moves aside; the contacts stay on the line (held_position).
///
/// The free length changes while the needle is bowed, so the mouth of the track pushes it out with −∂U/∂L (Bigoni et al. 2015),
/// without which the books would not close.
///
/// Where f falls, the tangent is negative, and reported so: such a bow is stable if what holds it is stiffer. Where nothing does,
/// the shift of `linearise` carries it past: τ dt² P_cr/L on its tangent, as a body with inertia has τM. What such a snap loses
/// is booked as `numerical`: the work of the forces at both its ends less what it stores, exact where the surroundings are
/// linear.
///
/// Leaves out: compression of the shaft, bending by lateral forces, inertia.
class ColumnNeedle : public NeedleModel {
public:
    /// `curve` outlives the needle.
    ColumnNeedle(const Setup& setup, const ColumnCurve& curve)
        : needle_(*setup.needle),
          buckling_(setup.buckling),
          curve_(curve),
          dt_(setup.dt),
          free_(3 * max_contacts),
          compliance_(3 * max_contacts, 3 * max_contacts) {
        set_free_length(needle_.length);
        state_ = trial_;
    }

    void predict(const Pose& base, double free_length, double dt) override;
    Linearisation linearise(ContactPoints points, double shift) override;
    StepReport try_step(ContactPoints points, Forces forces) override;
    void commit() override {
        state_ = trial_;
        snapping_ = false;
    }
    void rollback() override {
        trial_ = state_;
        snapping_ = false;
    }
    EnergyReport energy() const override { return {.stored = stored(trial_), .numerical = trial_.lost}; }

    Vector3 position(double arclength) const override { return position(trial_, arclength); }
    Vector3 tangent(double arclength) const override;
    Vector3 held_position(double arclength) const override { return straight(trial_, arclength); }
    Vector3 held_tangent(double /*arclength*/) const override { return trial_.base.axis(); }
    double entry_force() const override;
    Wrench base_wrench() const override { return state_.wrench; }
    NeedleState state() const override;
    void centreline(std::span<Vector3> points) const override;

protected:
    /// η = δ/L of the committed state, zero where it is straight.
    [[nodiscard]] double committed_shortening() const { return state_.bowed ? state_.relative() : 0.0; }

private:
    struct State {
        Pose base;
        double free_length = 0.0;       // [m] L, no less than the radius
        bool thick = false;             // the free length is less than that
        double depth = 0.0;             // [m] of the straight needle's tip below the surface
        double critical_load = 0.0;     // [N] P_cr(L), infinite where it never buckles
        double critical_slope = 0.0;    // [N/m] dP_cr/dL
        double shortening = 0.0;        // [m] δ
        bool bowed = false;
        double compression = 0.0;    // [N] N
        double lost = 0.0;           // [J] to snaps since the start
        Wrench wrench;

        [[nodiscard]] double relative() const { return shortening / free_length; }    // η
    };

    [[nodiscard]] double stored(const State& state) const;
    [[nodiscard]] double critical_load(double free_length) const;
    [[nodiscard]] double depth(double free_length) const;
    void set_free_length(double free_length);
    [[nodiscard]] StepReport bow_further();
    void note_what_a_snap_loses();
    void note_wrench(ContactPoints points, Forces forces, const Vector3& sum);
    [[nodiscard]] Vector3 position(const State& state, double arclength) const;
    [[nodiscard]] static Vector3 straight(const State& state, double arclength);

    NeedleSetup needle_;
    const BucklingModel* buckling_;    // may be null
    const ColumnCurve& curve_;
    double dt_;                // [s] of the step under way
    double tangent_ = 0.0;     // [N/m] dN/dδ of the latest linearisation
    bool snapping_ = false;    // this step leaves an unstable bow
    State trial_, state_;
    VectorX free_;          // 3n
    MatrixX compliance_;    // 3n × 3n
};

inline double ColumnNeedle::critical_load(double free_length) const {
    if (buckling_ == nullptr) return curve_.own_factor() * needle_.bending_stiffness() / (free_length * free_length);
    return buckling_->critical_load({.bending_stiffness = needle_.bending_stiffness(),
                                     .free_length = free_length,
                                     .inserted = std::max(0.0, needle_.length - free_length),
                                     .depth = depth(free_length),
                                     .radius = needle_.radius,
                                     .ends = needle_.ends});
}

inline double ColumnNeedle::depth(double free_length) const {
    return std::max(0.0, needle_.length - free_length) * std::abs(trial_.base.axis().z());
}

inline void ColumnNeedle::predict(const Pose& base, double free_length, double dt) {
    trial_.base = base;
    if (dt > 0.0) dt_ = dt;
    set_free_length(free_length);
}

inline void ColumnNeedle::set_free_length(double free_length) {
    const double length = std::max(free_length, needle_.radius);
    trial_.thick = free_length < needle_.radius;
    if (length == trial_.free_length && depth(length) == trial_.depth) return;
    trial_.free_length = length;
    trial_.depth = depth(length);
    trial_.critical_load = critical_load(length);
    if (buckling_ == nullptr) {
        trial_.critical_slope = -2.0 * trial_.critical_load / length;
    } else {
        const double h = 1e-4 * length;
        trial_.critical_slope = (critical_load(length + h) - critical_load(length - h)) / (2.0 * h);
    }
}

inline Linearisation ColumnNeedle::linearise(ContactPoints points, double shift) {
    // At a limit load the tangent is nothing and the compliance infinite: kept finite.
    constexpr double least_slope = 1e-9;
    const auto count = static_cast<Eigen::Index>(points.size());
    const Vector3 axis = trial_.base.axis();
    double yielding = 0.0;    // [m/N] dδ/dN
    double shortening = trial_.shortening;
    if (trial_.bowed) {
        const CurvePoint now = curve_.at(trial_.relative());
        snapping_ = snapping_ || (shift > 0.0 && now.slope < 0.0);
        const double slope = now.slope + shift * dt_ * dt_;
        tangent_ = trial_.critical_load * std::copysign(std::max(std::abs(slope), least_slope), slope) / trial_.free_length;
        yielding = 1.0 / tangent_;
        shortening -= trial_.critical_load * now.load * yielding;    // where the tangent would end without any load
    }
    const Matrix3 block = yielding * axis * axis.transpose();
    for (Eigen::Index i = 0; i < count; ++i) {
        free_.segment<3>(3 * i) = trial_.base.position + (points[i].arclength - shortening) * axis;
        for (Eigen::Index j = 0; j < count; ++j) compliance_.block<3, 3>(3 * j, 3 * i) = block;
    }
    return {.free = {free_.data(), 3 * count},
            .compliance = {compliance_.data(), 3 * count, 3 * count, Eigen::OuterStride<>(compliance_.outerStride())},
            .negatives = yielding < 0.0 ? 1 : 0};
}

inline StepReport ColumnNeedle::try_step(ContactPoints points, Forces forces) {
    Vector3 sum = Vector3::Zero();
    for (std::size_t i = 0; i < points.size(); ++i) sum += forces.segment<3>(3 * static_cast<Eigen::Index>(i));
    trial_.compression = -sum.dot(trial_.base.axis());

    StepReport report;
    if (trial_.bowed) {
        report = bow_further();
        if (snapping_) note_what_a_snap_loses();
    } else if (trial_.compression > trial_.critical_load) {    // the straight branch is refused above the critical load
        trial_.bowed = true;
        report = {.residual = trial_.compression - trial_.critical_load, .tangent_changed = true};
    }
    note_wrench(points, forces, sum);
    return report;
}

// Along the tangent that linearise has just used.
inline StepReport ColumnNeedle::bow_further() {
    trial_.shortening += (trial_.compression - trial_.critical_load * curve_.at(trial_.relative()).load) / tangent_;
    trial_.bowed = trial_.shortening > 0.0;
    if (!trial_.bowed) {
        trial_.shortening = 0.0;
        return {.tangent_changed = true};
    }
    return {.residual = std::abs(trial_.compression - trial_.critical_load * curve_.at(trial_.relative()).load)};
}

inline void ColumnNeedle::note_what_a_snap_loses() {
    State before = trial_;
    before.shortening = state_.shortening;
    const double work = 0.5 * (state_.compression + trial_.compression) * (trial_.shortening - state_.shortening);
    trial_.lost = state_.lost + std::max(0.0, work - (stored(trial_) - stored(before)));
}

inline void ColumnNeedle::note_wrench(ContactPoints points, Forces forces, const Vector3& sum) {
    trial_.wrench.force = -sum;
    trial_.wrench.moment.setZero();
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Vector3 arm = held_position(points[i].arclength) - trial_.base.position;
        trial_.wrench.moment -= arm.cross(forces.segment<3>(3 * static_cast<Eigen::Index>(i)));
    }
}

inline double ColumnNeedle::stored(const State& state) const {
    if (!state.bowed) return 0.0;
    return state.critical_load * state.free_length * curve_.at(state.relative()).energy;
}

inline double ColumnNeedle::entry_force() const {
    if (!trial_.bowed || trial_.thick) return 0.0;
    const double eta = trial_.relative();
    const CurvePoint now = curve_.at(eta);
    return -trial_.critical_slope * trial_.free_length * now.energy - trial_.critical_load * (now.energy - eta * now.load);
}

inline NeedleState ColumnNeedle::state() const {
    return {.critical_load = state_.critical_load,
            .axial_load = state_.compression,
            .deflection = state_.bowed ? state_.free_length * curve_.deflection(state_.relative()) : 0.0,
            .slope = state_.bowed ? curve_.largest_slope(state_.relative()) : 0.0,
            .buckled = state_.bowed};
}

// On the needle's line, as far from the base as the shortening leaves it.
inline Vector3 ColumnNeedle::straight(const State& state, double arclength) {
    return state.base.position + (arclength - state.shortening) * state.base.axis();
}

inline Vector3 ColumnNeedle::position(const State& state, double arclength) const {
    if (!state.bowed) return straight(state, arclength);
    const Vector3 side = state.free_length * state.base.bow_direction();
    if (arclength >= state.free_length) return straight(state, arclength) + curve_.end_aside(state.relative()) * side;
    const BowPoint point = curve_.bow(state.relative(), std::max(0.0, arclength / state.free_length));
    return state.base.position + point.along * state.free_length * state.base.axis() + point.aside * side;
}

inline Vector3 ColumnNeedle::tangent(double arclength) const {
    const Vector3 axis = trial_.base.axis();
    if (!trial_.bowed || arclength >= trial_.free_length) return axis;
    const double angle = curve_.bow(trial_.relative(), std::max(0.0, arclength / trial_.free_length)).tangent;
    return std::cos(angle) * axis + std::sin(angle) * trial_.base.bow_direction();
}

inline void ColumnNeedle::centreline(std::span<Vector3> points) const {
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double arclength = needle_.length * static_cast<double>(i) / static_cast<double>(points.size() - 1);
        points[i] = position(state_, arclength);
    }
}

}    // namespace stylet
