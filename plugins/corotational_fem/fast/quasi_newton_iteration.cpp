// One iteration: a direction, how far to go along it, what it has taught, and whether that was enough.
#include "fast/quasi_newton.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace stylet::corotational_fem {

namespace {

// Contraction: each iteration leaves at most about a tenth where the tissue turns little, which can't be measured where there is
// one iteration only. Where inertia rules, what is left of the residual tells better: there a third of it is an error's share.
constexpr double least_contraction = 0.1;
constexpr double greatest_contraction = 0.9;
constexpr double residual_share = 3.0;

// With another time step than the factor's, iterations leave something of each mode, which adds up from step to step.
constexpr double strictness = 0.1;

// Single precision: steps below this part of the displacements are its noise.
constexpr double resolution = 1e-5;
// A tissue let go comes back to nothing, and single precision knows no better where that is than by this part of its way.
constexpr double move_resolution = 1e-6;
// Of a pair's step: noise is less than a tenth of what it teaches.
constexpr double least_lesson = 1e-4;
// Of the curvature along a step, by what was known before: a pair beyond these is of a tissue that buckles, or of noise.
constexpr double least_curvature = 1e-2, greatest_curvature = 1e2;

// A step is too long where the residual along it has turned round by this much, or where the potential rises by more than its
// rounding.
constexpr double overshoot = 0.9;
constexpr double rounding = 2e-6;    // of the elastic energy
constexpr double least_cut = 0.1, greatest_cut = 0.5;
constexpr int most_cuts = 10;

}    // namespace

float QuasiNewton::inertia() const {
    return motion_.implicit ? static_cast<float>(1.0 / (step_length() * step_length())) : 0.0F;
}

// Where the step began, for its damper; its undamped forces into `forces`.
void QuasiNewton::start_damper(NodalVector& forces) {
    loops_.each(
        [&](int i) { quad(start_[i]) = __builtin_convertvector(reinterpret_cast<const DoubleQuad&>(trial_.from[i]), Quad); });
    elements_.start(start_.data(), forces.data());
}

// Further along ahead_, and where that is in single precision.
void QuasiNewton::move(float fraction) {
    const auto squared = loops_.sums<2>([&](int i, auto& sums) {
        Quad& moved = quad(trial_.moved[i]);
        moved += fraction * quad(ahead_[i]);
        const DoubleQuad from = reinterpret_cast<const DoubleQuad&>(trial_.from[i]);
        const Quad at = __builtin_convertvector(from + __builtin_convertvector(moved, DoubleQuad), Quad);
        quad(x_[i]) = at;
        sums[0] += at * at;
        sums[1] += moved * moved;
    });
    size_ = std::sqrt(squared[0]);
    noise_ = resolution * size_ + move_resolution * std::sqrt(squared[1]);
}

// What the trial displacements say, whatever acts from outside.
void QuasiNewton::evaluate() {
    const ElementSums sums =
        damped() ? elements_.strain(x_.data(), start_.data(), motion_.damping_time / step_length(), trial_.inner.data())
                 : elements_.strain(x_.data(), trial_.inner.data());
    trial_.elastic = sums.elastic;
    trial_.dissipated = sums.dissipated;
    trial_.inverted = sums.inverted;
}

// r = w + f + Jᵀλ − inner − M (u − ũ)/dt². Returns what it is along ahead_ [J].
double QuasiNewton::balance() {
    if (!outer_known_) {
        loops_.each([&](int i) { outer_[i] = trial_.loads[i]; });
        contacts_.press({trial_.lambda.data(), static_cast<std::size_t>(3 * trial_.contacts)}, outer_);
        outer_known_ = true;
    }
    const float rate = inertia();
    const auto [squared, along] = loops_.sums<2>([&](int i, auto& sums) {
        const Quad resisting = quad(trial_.inner[i]) + rate * mass_[i] * (quad(trial_.moved[i]) - quad(trial_.coasting[i]));
        const Quad left = quad(outer_[i]) - resisting;
        quad(residual_[i]) = left;
        sums[0] += softness_[i] * left * left;
        sums[1] += left * quad(ahead_[i]);
    });
    residual_size_ = std::sqrt(squared);
    return along;
}

// A step shorter than the factor's has more inertia: taken so, the factor's answers are right between the modes of stiffness and
// those of inertia.
double QuasiNewton::answer_scale() const {
    const double ratio = motion_.dt / step_length();
    return motion_.implicit && ratio > 1.0 ? 2.0 / (1.0 + ratio * ratio) : 1.0;
}

// ahead_ = H r
void QuasiNewton::find_direction() {
    if (trial_.learnt_dt != step_length()) pairs_.forget();
    trial_.learnt_dt = step_length();
    pairs_.begin(residual_.data(), q_.data());
    if (const auto scale = static_cast<float>(answer_scale()); scale != 1.0F) {
        loops_.each([&](int i) { quad(q_[i]) *= scale; });
    }
    panels_->solve(q_.data(), answer_.data(), workers_);
    pairs_.finish(answer_.data(), ahead_.data());
    ahead_known_ = true;
}

// Returns whether the state is now within the accuracy.
bool QuasiNewton::iterate() {
    ++iterations_;
    if (!ahead_known_) find_direction();
    Step step = measure();
    if (!(step.slope > 0.0) && pairs_.count() > 0) {
        pairs_.forget();
        find_direction();
        step = measure();
    }
    ahead_known_ = false;
    if (!(step.slope > 0.0)) return step.squared == 0.0;
    std::swap(residual_, before_);
    go(step, 1.0);
    double next = shortened(step);
    for (int cuts = 0; next < step.fraction && cuts < most_cuts; ++cuts) {
        go(step, next);
        next = shortened(step);
    }
    if (next < step.fraction) {
        go(step, 0.0);
        // The factor alone points downhill: where there is no downhill within the accuracy, single precision ends.
        if (pairs_.count() == 0) return std::sqrt(step.squared) <= accuracy_ * size_;
        pairs_.forget();
        return false;
    }
    learn(step);
    return enough(step);
}

QuasiNewton::Step QuasiNewton::measure() const {
    const float rate = inertia();
    const auto sums = loops_.sums<4>([&](int i, auto& parts) {
        const Quad d = quad(ahead_[i]);
        parts[0] += quad(residual_[i]) * d;
        parts[1] += d * d;
        parts[2] += quad(trial_.inner[i]) * d;
        parts[3] += rate * mass_[i] * d * d;
    });
    return {.slope = sums[0],
            .squared = sums[1],
            .inner = sums[2],
            .inertia = sums[3],
            .elastic = trial_.elastic + 0.5 * trial_.dissipated,
            .residual = residual_size_,
            .fraction = 0.0,
            .along = sums[0]};
}

void QuasiNewton::go(Step& step, double fraction) {
    move(static_cast<float>(fraction - step.fraction));
    step.fraction = fraction;
    evaluate();
    step.along = balance();
}

// The fraction to go back to where the step was too long, else its own. The potential is Ψ + |u − ũ|²M/(2 dt²) − (w + f + Jᵀλ)·u.
double QuasiNewton::shortened(const Step& step) const {
    const double t = step.fraction;
    const double elastic = trial_.elastic + 0.5 * trial_.dissipated;
    const double rise = elastic - step.elastic - t * (step.slope + step.inner) + 0.5 * t * t * step.inertia;
    const bool rises = !(rise <= rounding * (elastic + step.elastic));    // true of what is not a number
    const bool overshoots = !(step.along >= -overshoot * step.slope);
    if (!rises && !overshoots) return t;
    const double secant = step.slope / (step.slope - step.along);
    return t * (secant > least_cut && secant < greatest_cut ? secant : (secant <= least_cut ? least_cut : greatest_cut));
}

void QuasiNewton::learn(const Step& step) {
    const double curvature = (step.slope - step.along) / (step.fraction * step.slope);    // by what was known before
    if (!(curvature >= least_curvature && curvature <= greatest_curvature)) return;
    if (step.fraction * std::sqrt(step.squared) < least_lesson * size_) return;
    const auto fraction = static_cast<float>(step.fraction);
    Float4 *const s = pairs_.step(), *const y = pairs_.change();
    loops_.each([&](int i) {
        quad(s[i]) = fraction * quad(ahead_[i]);
        quad(y[i]) = quad(before_[i]) - quad(residual_[i]);
    });
    pairs_.keep(step.fraction * (step.slope - step.along));
}

bool QuasiNewton::enough(const Step& step) {
    const double length = step.fraction * std::sqrt(step.squared);
    const bool measured = last_step_ > 0.0;
    if (measured) trial_.contraction = length / last_step_;
    last_step_ = length;
    if (motion_.implicit && step_length() != motion_.dt) return enough_elsewhere(length, measured);
    const double contraction = std::max(trial_.contraction, least_contraction);
    double left = contraction / (1.0 - std::min(contraction, greatest_contraction));    // of all steps to come
    if (motion_.implicit) left = std::min(left, residual_share * residual_size_ / step.residual);
    return length <= noise_ || (step.fraction == 1.0 && length * left <= accuracy_ * size_);
}

// With another time step than the factor's. What is left then is all the steps to come.
bool QuasiNewton::enough_elsewhere(double length, bool measured) const {
    const double ratio = motion_.dt / step_length();
    const double slowest = std::max(0.0, 1.0 - ratio * ratio);
    const double contraction = std::clamp(measured ? trial_.contraction : std::max(trial_.contraction, slowest), 0.5, 0.999);
    const double left = contraction / (1.0 - contraction);
    return length <= strictness * noise_ || length * left <= strictness * accuracy_ * size_;
}

double QuasiNewton::imbalance() const {
    double greatest = 0.0;
    for (const Float4& r : residual_) greatest = std::max(greatest, double{r.x} * r.x + double{r.y} * r.y + double{r.z} * r.z);
    return std::isfinite(residual_size_) ? std::sqrt(greatest) : std::numeric_limits<double>::infinity();
}

}    // namespace stylet::corotational_fem
