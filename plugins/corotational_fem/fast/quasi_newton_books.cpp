// Where the energy of a step goes.
#include "fast/quasi_newton.h"

#include <algorithm>

namespace stylet::corotational_fem {

namespace {

Quad single(const Vector3& v) {
    return Quad{static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z()), 0.0F};
}

}    // namespace

// What holds against forces from outside: inner forces and inertia M (u − ũ)/dt². Before its clock runs, a tissue that has
// inertia is about to be let go: its first acceleration is gravity's.
auto QuasiNewton::resisting() const {
    const bool waits = motion_.implicit && trial_.dt == 0.0;
    return [this, rate = inertia(), held = single(waits ? motion_.gravity : Vector3(Vector3::Zero()))](int i) {
        const Quad acceleration = rate * (quad(trial_.moved[i]) - quad(trial_.coasting[i])) + held;
        return quad(trial_.inner[i]) + mass_[i] * acceleration;
    };
}

// Before the step moves on: its books begin where the last one's ended.
void QuasiNewton::open_books() {
    const auto resisting_at = resisting();
    loops_.each([&](int i) {
        quad(origin_.resisting[i]) = resisting_at(i);
        origin_.moved[i] = trial_.moved[i];
    });
    origin_.elastic = trial_.elastic;
    origin_.kinetic = trial_.kinetic;
    origin_.dissipated = trial_.dissipated;
    origin_.damping = state_.damping;
    origin_.numerical = state_.numerical;
}

// Forces from outside did work against what resists them, by the trapezoid rule; what of it is neither stored nor damped is the
// integrator's.
void QuasiNewton::close_books() {
    const auto resisting_at = resisting();
    const Quad gravity = single(motion_.gravity);
    const auto [twice_work, twice_kinetic, fallen] = loops_.sums<3>([&](int i, auto& sums) {
        const Quad moved = quad(trial_.moved[i]);
        sums[0] += (quad(origin_.resisting[i]) + resisting_at(i)) * (moved - quad(origin_.moved[i]));
        sums[1] += mass_[i] * moved * moved;
        sums[2] += mass_[i] * moved * gravity;
    });
    trial_.kinetic = motion_.implicit && trial_.dt > 0.0 ? 0.5 * twice_kinetic / (trial_.dt * trial_.dt) : 0.0;
    trial_.weight = trial_.weight_before - fallen;
    const double lost = trial_.dissipated - origin_.dissipated;
    trial_.damping = origin_.damping + lost;
    if (!motion_.implicit && !damped()) return;    // nothing is integrated
    trial_.numerical =
        origin_.numerical + 0.5 * twice_work - lost - (trial_.elastic - origin_.elastic) - (trial_.kinetic - origin_.kinetic);
}

EnergyReport QuasiNewton::energy() const {
    return {.stored = trial_.elastic + trial_.weight,
            .kinetic = trial_.kinetic,
            .damping = trial_.damping,
            .numerical = trial_.numerical};
}

}    // namespace stylet::corotational_fem
