// The paper's needle: a column that stays straight up to its critical load and then bows as a half sine.
#pragma once

#include "column_curve.h"

#include <stylet/buckling_model.h>
#include <stylet/needle_model.h>

namespace stylet::beam_column {

/// One generalised coordinate, the shortening δ ≥ 0 [m] of the free length L:
///
///     δ = 0 and N ≤ P_cr(L),   or   δ > 0 and N = P_cr(L) f(δ/L),   U = P_cr(L) L ∫₀^(δ/L) f dη
///
/// with N the compression and f the paper's Eqs. (4), (5) (column_curve.h). The stored energy is ∫F dδ, not the sine's bending
/// energy. The inserted part is straight and moves as one. Eq. (4) gives the shape that is drawn and the bow that is reported.
///
/// The free length changes while the needle is bowed, so the mouth of the track pushes it out with −∂U/∂L (Bigoni et al. 2015),
/// without which the books would not close. Source: He, Chen, Tang, section II.D; P_cr from the scene's `buckling`, for its
/// declared ends. A scene without `buckling` gives a needle that never buckles. Validity: end slope up to 45°, said when passed.
/// Leaves out: a limit load (a real clamped-pinned column carries at most 1.14 P_cr), bending by lateral forces, inertia.
class BeamColumn final : public NeedleModel {
public:
    explicit BeamColumn(const Setup& setup);

    void predict(const Pose& base, double free_length, double dt) override;
    Linearisation linearise(ContactPoints points, double shift) override;
    StepReport try_step(ContactPoints points, Forces forces) override;
    void commit() override { state_ = trial_; }
    void rollback() override { trial_ = state_; }
    EnergyReport energy() const override { return {.stored = stored(trial_)}; }

    Vector3 position(double arclength) const override { return position(trial_, arclength); }
    Vector3 tangent(double arclength) const override;
    Vector3 held_position(double arclength) const override { return straight(trial_, arclength); }
    Vector3 held_tangent(double /*arclength*/) const override { return trial_.base.axis(); }
    double entry_force() const override;
    Wrench base_wrench() const override { return state_.wrench; }
    NeedleState state() const override;
    void centreline(std::span<Vector3> points) const override;
    const char* beyond_validity() const override;

private:
    struct State {
        Pose base;
        double free_length = 0.0;       // [m] L
        double depth = 0.0;             // [m] of the straight needle's tip below the surface
        double critical_load = 0.0;     // [N] P_cr(L), infinite without buckling
        double critical_slope = 0.0;    // [N/m] dP_cr/dL
        double shortening = 0.0;        // [m] δ
        bool bowed = false;
        double compression = 0.0;    // [N] N
        Wrench wrench;
    };

    double stored(const State& state) const;
    double critical_load(double free_length) const;
    double depth(double free_length) const;
    void set_free_length(double free_length);
    Vector3 position(const State& state, double arclength) const;
    static Vector3 straight(const State& state, double arclength);

    NeedleSetup needle_;
    const BucklingModel* buckling_;    // may be null
    ColumnCurve curve_;
    State trial_, state_;
    VectorX free_;          // 3n
    MatrixX compliance_;    // 3n × 3n
};

}    // namespace stylet::beam_column
