// The motion of a hand: poses with straight ways in between, and how a scene writes one. For devices that bring their own hand.
//
//     tip_start: [0 mm, 0 mm, 2 mm]
//     motion:
//       - {insert: 80 mm, speed: 10 mm/s}
//       - {hold: 1 s}
//       - {withdraw: 80 mm, speed: 20 mm/s}
#pragma once

#include <stylet/parameters.h>

#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

namespace stylet {

/// A pose of the needle's base and when it is reached.
struct PoseKey {
    double time;    // [s]
    Pose pose;
};

/// Where the base is at any time:
///
///     x(t) = xᵢ + s (xᵢ₊₁ − xᵢ),   q(t) = slerp(qᵢ, qᵢ₊₁, s),   s = (t − tᵢ)/(tᵢ₊₁ − tᵢ)
///
/// held before the first and after the last key. Source: Shoemake 1985 for slerp.
class PosePath {
public:
    /// At least one key; times rise.
    explicit PosePath(std::vector<PoseKey> keys) : keys_(std::move(keys)) {}

    [[nodiscard]] Pose at(double time) const {
        const auto after = std::upper_bound(keys_.begin(), keys_.end(), time,
                                            [](double wanted, const PoseKey& key) { return wanted < key.time; });
        if (after == keys_.begin()) return keys_.front().pose;
        if (after == keys_.end()) return keys_.back().pose;
        const PoseKey& from = *std::prev(after);
        const double fraction = (time - from.time) / (after->time - from.time);
        return {from.pose.position + fraction * (after->pose.position - from.pose.position),
                from.pose.rotation.slerp(fraction, after->pose.rotation).normalized()};
    }

    [[nodiscard]] double end() const { return keys_.back().time; }    // [s]

private:
    std::vector<PoseKey> keys_;
};

/// The fields of the records `motion`.
inline constexpr Parameter motion_step[] = {
    optional(number("insert", "m", positive, "how far the hand pushes along the direction of insertion")),
    optional(number("withdraw", "m", positive, "how far the hand pulls back")),
    optional(number("hold", "s", positive, "how long the hand keeps still")),
    optional(number("speed", "m/s", positive, "of insert and withdraw; left out with hold")),
};

/// The parameters that go with `motion` and may be left out.
inline constexpr Parameter motion_direction =
    optional(vector3("direction", "1", "of insertion, of any length but zero; left out: straight down"));
inline constexpr Parameter motion_cycles =
    optional(integer("cycles", {.least = 1, .greatest = 100000}, "how many times the motion runs; left out: once"));

namespace hand_motion {

/// What one step does.
struct Step {
    double advance;     // [m] along the direction of insertion
    double duration;    // [s]
};

inline Step read_step(const Parameters& step, std::size_t index) {
    const auto refuse = [index](const std::string& message) {
        throw Error("motion", "step " + std::to_string(index + 1) + ": " + message);
    };
    const int kinds =
        static_cast<int>(step.has("insert")) + static_cast<int>(step.has("withdraw")) + static_cast<int>(step.has("hold"));
    if (kinds != 1) refuse("found " + std::to_string(kinds) + " of insert, withdraw and hold, wanted exactly one");
    if (step.has("hold")) {
        if (step.has("speed")) refuse("found a speed beside hold, wanted hold alone");
        return {0.0, step.number("hold")};
    }
    if (!step.has("speed")) refuse("found no speed, wanted one beside insert or withdraw");
    const double distance = step.has("insert") ? step.number("insert") : step.number("withdraw");
    return {step.has("insert") ? distance : -distance, distance / step.number("speed")};
}

inline Vector3 read_direction(const Parameters& parameters) {
    if (!parameters.has("direction")) return {0.0, 0.0, -1.0};
    const Vector3& direction = parameters.vector3("direction");
    if (!(direction.norm() > 0.0)) throw Error("direction", "found a vector of no length, wanted the direction of insertion");
    return direction.normalized();
}

}    // namespace hand_motion

/// The motion that a scene writes with `tip_start`, `motion`, `direction` and `cycles`: the tip goes from `tip_start` along the
/// direction, the base is one `needle_length` [m] behind. Throws Error at the parameter that makes no sense.
inline PosePath read_motion(const Parameters& parameters, double needle_length) {
    if (!parameters.has("tip_start")) throw Error("motion", "found no tip_start, wanted where the tip is at time 0");
    const Vector3 direction = hand_motion::read_direction(parameters);
    const Vector3 start = parameters.vector3("tip_start") - needle_length * direction;
    const Quaternion rotation = Quaternion::FromTwoVectors(Vector3(0.0, 0.0, -1.0), direction).normalized();
    const std::int64_t cycles = parameters.has("cycles") ? parameters.integer("cycles") : 1;

    std::vector<hand_motion::Step> steps;
    for (const Parameters& step : parameters.records("motion")) steps.push_back(hand_motion::read_step(step, steps.size()));
    if (steps.empty()) throw Error("motion", "found no step, wanted at least one");

    std::vector<PoseKey> keys{{0.0, {start, rotation}}};
    double time = 0.0;       // [s]
    double advance = 0.0;    // [m]
    for (std::int64_t cycle = 0; cycle < cycles; ++cycle) {
        for (const hand_motion::Step& step : steps) {
            time += step.duration;
            advance += step.advance;
            keys.push_back({time, {start + advance * direction, rotation}});
        }
    }
    return PosePath(std::move(keys));
}

}    // namespace stylet
