#include "core/device/force_limiter.h"

#include <algorithm>

namespace stylet::core {

namespace {

void shorten(Vector3& v, double most) {
    if (const double length = v.norm(); length > most) v *= most / length;
}

void slew(Vector3& to, const Vector3& from, double most) {
    Vector3 change = to - from;
    shorten(change, most);
    to = from + change;
}

}    // namespace

ForceLimiter::ForceLimiter(const DeviceLimits& device, std::optional<double> force_limit) : limits_(device) {
    limits_.force = std::min(limits_.force, force_limit.value_or(limits_.force));
}

Wrench ForceLimiter::limit(const Wrench& asked, double dt) {
    if (!asked.finite()) {    // a simulation that has lost itself: nothing of it may reach the hand
        faulted_ = true;
        last_ = {};
        return last_;
    }
    running_ += dt;
    const double fade = limits_.soft_start > 0.0 ? std::min(1.0, running_ / limits_.soft_start) : 1.0;
    Wrench out = faulted_ ? Wrench{} : asked;
    shorten(out.force, limits_.force);
    shorten(out.moment, limits_.moment);
    const double rate = limits_.force_rate * dt;
    slew(out.force, last_.force, rate);
    slew(out.moment, last_.moment, limits_.force > 0.0 ? rate * limits_.moment / limits_.force : 0.0);
    last_ = out;
    return {.force = fade * out.force, .moment = fade * out.moment};
}

}    // namespace stylet::core
