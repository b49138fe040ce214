#include "core/device/force_chain.h"

#include <algorithm>

namespace stylet::core {

namespace {

bool shorten_to(double most, Vector3& v) {
    const double length = v.norm();
    if (length <= most) return false;
    v *= most / length;
    return true;
}

bool slew_from(const Vector3& last, double most, Vector3& v) {
    Vector3 change = v - last;
    if (!shorten_to(most, change)) return false;
    v = last + change;
    return true;
}

}    // namespace

ForceChain::ForceChain(const DeviceLimits& device, std::optional<double> force_limit)
    : limits_(device), moment_rate_(device.force_rate * (device.moment / device.force)) {
    limits_.force = std::min(limits_.force, force_limit.value_or(limits_.force));
}

Wrench ForceChain::limit(const Wrench& asked, bool stale, double dt) {
    if (!asked.finite()) {    // a simulation that has lost itself: nothing of it may reach the hand
        faulted_ = true;
        last_ = {};
    }
    counts_.fault += faulted_;
    if (!faulted_ && !stale && !latched_) {
        Wrench answer = asked;
        shorten(answer);
        slew(answer, dt);
        last_ = answer;
    }
    fade(stale, dt);
    return {.force = level_ * last_.force, .moment = level_ * last_.moment};
}

Wrench ForceChain::let_go(double dt) {
    level_ = std::max(0.0, level_ - dt / limits_.ramp_down);
    return {.force = level_ * last_.force, .moment = level_ * last_.moment};
}

void ForceChain::shorten(Wrench& wrench) {
    const bool force = shorten_to(limits_.force, wrench.force), moment = shorten_to(limits_.moment, wrench.moment);
    counts_.magnitude += force || moment;
}

void ForceChain::slew(Wrench& wrench, double dt) {
    const bool force = slew_from(last_.force, limits_.force_rate * dt, wrench.force);
    const bool moment = slew_from(last_.moment, moment_rate_ * dt, wrench.moment);
    counts_.slew += force || moment;
}

void ForceChain::fade(bool stale, double dt) {
    counts_.stale += stale;
    trusted_ = stale ? 0.0 : trusted_ + dt;
    if (faulted_ || stale) {
        level_ = std::max(0.0, level_ - dt / limits_.ramp_down);
        latched_ = latched_ || (stale && level_ == 0.0);
    } else if (latched_) {
        if (trusted_ < rearm_after) return;
        latched_ = false;
    } else {
        level_ = std::min(1.0, level_ + dt / limits_.soft_start);
        counts_.soft_start += level_ < 1.0;
    }
    if (level_ == 0.0) last_ = {};
}

}    // namespace stylet::core
