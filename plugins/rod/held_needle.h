// For tests: a needle plugin whose contacts the test holds or pushes, tick by tick, as core's coupling would.
#pragma once

#include <stylet/contract/plugin.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

namespace stylet::rod {

/// A needle whose base rests, and whose contact points are each, in each direction of the world, held at a place or pushed by a
/// force. Newton's method as in core: each step with as much shift as its branch takes, done on a step that took none; a tick
/// that finds no balance is taken in halves.
class HeldNeedle {
public:
    HeldNeedle(const std::string& file, const contract::Case& with, const std::vector<double>& arclengths)
        : needle(contract::make<NeedleModel>(file, with)), length_(with.needle.length), dt_(with.dt) {
        for (const double arclength : arclengths)
            points_.push_back({.material = Vector3::Zero(), .span = Vector3::Zero(), .arclength = arclength, .tip = false});
        held = std::vector(3 * points_.size(), false);
        force = before_ = VectorX::Zero(3 * points_.size());
        at = VectorX(force.size());
        for (int i = 0; i < count(); ++i) at.segment<3>(3 * i) = place(i);
        was_at_ = at;
        stored_at_first_ = needle->energy().stored;
    }

    std::unique_ptr<NeedleModel> needle;
    std::vector<bool> held;    // 3n
    VectorX at;                // 3n, [m] where it is held; at first where it is
    VectorX force;             // 3n, [N] on the needle: what pushes, and after a tick what holds
    double work = 0.0;         // [J] of all of these, by trapezoids
    double peak_work = 0.0;    // [J]

    [[nodiscard]] Vector3 place(int point) const { return needle->position(points_[point].arclength); }    // [m]

    /// False where it finds no balance, to 1e-9 N.
    [[nodiscard]] bool tick() { return move(at, dt_, 0); }

    /// [J] work that is neither stored, nor moving, nor declared lost.
    [[nodiscard]] double residual() const {
        const EnergyReport books = needle->energy();
        return work - (books.stored - stored_at_first_ + books.kinetic + books.damping + books.numerical);
    }

private:
    [[nodiscard]] int count() const { return static_cast<int>(points_.size()); }

    bool move(const VectorX& target, double dt, int halvings) {
        constexpr int most_halvings = 10;
        if (step(target, dt)) return true;
        if (halvings == most_halvings) return false;
        const VectorX half = 0.5 * (was_at_ + target);
        return move(half, 0.5 * dt, halvings + 1) && move(target, 0.5 * dt, halvings + 1);
    }

    bool step(const VectorX& target, double dt) {
        std::vector<Vector3> from;
        for (int i = 0; i < count(); ++i) from.push_back(place(i));
        needle->predict({}, length_, dt);
        if (!balance(target, dt)) {
            needle->rollback();
            return false;
        }
        needle->commit();
        for (int i = 0; i < count(); ++i) work += 0.5 * (before_ + force).segment<3>(3 * i).dot(place(i) - from[i]);
        peak_work = std::max(peak_work, work);
        before_ = force;
        was_at_ = target;
        return true;
    }

    bool balance(const VectorX& target, double dt) {
        constexpr int most_steps = 60, most_shifts = 32;
        constexpr double enough = 1e-9;    // [N]
        for (int step = 0; step < most_steps; ++step) {
            double shift = 0.0;    // [1/s²]
            for (int shifts = 0; !solve(target, shift); ++shifts) {
                if (shifts == most_shifts) return false;
                shift = shift == 0.0 ? 0.25 / (dt * dt) : 2.0 * shift;
            }
            const StepReport report = needle->try_step(points_, {force.data(), force.size()});
            if (!std::isfinite(report.residual)) return false;
            if (shift == 0.0 && report.residual <= enough && !report.tangent_changed) return true;
        }
        return false;
    }

    // The forces that hold what is held. False where holding does not take away as many ways of leaving as the free needle has
    // (Haynsworth).
    bool solve(const VectorX& target, double shift) {
        const Linearisation linear = needle->linearise(points_, shift);
        std::vector<int> rows;
        for (int row = 0; row < 3 * count(); ++row) {
            if (held[row]) rows.push_back(row);
        }
        for (const int row : rows) force[row] = 0.0;
        const VectorX off = target - linear.free - linear.compliance * force;
        const Eigen::SelfAdjointEigenSolver<MatrixX> spectrum(linear.compliance(rows, rows));
        if ((spectrum.eigenvalues().array() < 0.0).count() != linear.negatives) return false;
        const MatrixX& modes = spectrum.eigenvectors();
        force(rows) = modes * (modes.transpose() * off(rows)).cwiseQuotient(spectrum.eigenvalues());
        return true;
    }

    double length_, dt_;    // [m], [s]
    std::vector<ContactPoint> points_;
    VectorX before_;            // [N] at the last step's end
    VectorX was_at_;            // [m]
    double stored_at_first_;    // [J]
};

}    // namespace stylet::rod
