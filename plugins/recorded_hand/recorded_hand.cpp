#include "recorded_hand.h"

#include "pose_file.h"

#include <algorithm>

namespace stylet::recorded_hand {
namespace {

void refuse_step(std::size_t index, const std::string& message) {
    throw Error("motion", "step " + std::to_string(index + 1) + ": " + message);
}

/// One step of a motion.
struct Step {
    double advance;     // [m] along the direction of insertion
    double duration;    // [s]
};

Step read_step(const Parameters& step, std::size_t index) {
    const int kinds =
        static_cast<int>(step.has("insert")) + static_cast<int>(step.has("withdraw")) + static_cast<int>(step.has("hold"));
    if (kinds != 1) refuse_step(index, "found " + std::to_string(kinds) + " of insert, withdraw and hold, wanted exactly one");
    if (step.has("hold")) {
        if (step.has("speed")) refuse_step(index, "found a speed beside hold, wanted hold alone");
        return {0.0, step.number("hold")};
    }
    if (!step.has("speed")) refuse_step(index, "found no speed, wanted one beside insert or withdraw");
    const double distance = step.has("insert") ? step.number("insert") : step.number("withdraw");
    return {step.has("insert") ? distance : -distance, distance / step.number("speed")};
}

Vector3 direction_of(const Parameters& parameters) {
    if (!parameters.has("direction")) return {0.0, 0.0, -1.0};
    const Vector3& direction = parameters.vector3("direction");
    if (!(direction.norm() > 0.0)) throw Error("direction", "found a vector of no length, wanted the direction of insertion");
    return direction.normalized();
}

/// The base poses of the motion: at its start and after each step of each cycle.
std::vector<RecordedHand::Key> keys_of_motion(const Parameters& parameters, double needle_length) {
    if (!parameters.has("tip_start")) throw Error("motion", "found no tip_start, wanted where the tip is at time 0");
    const Vector3 direction = direction_of(parameters);
    const Vector3 start = parameters.vector3("tip_start") - needle_length * direction;
    const Quaternion rotation = Quaternion::FromTwoVectors(Vector3(0.0, 0.0, -1.0), direction).normalized();
    const std::int64_t cycles = parameters.has("cycles") ? parameters.integer("cycles") : 1;

    std::vector<Step> steps;
    for (const Parameters& step : parameters.records("motion")) steps.push_back(read_step(step, steps.size()));
    if (steps.empty()) throw Error("motion", "found no step, wanted at least one");

    std::vector<RecordedHand::Key> keys{{0.0, {start, rotation}}};
    double time = 0.0;       // [s]
    double advance = 0.0;    // [m]
    for (std::int64_t cycle = 0; cycle < cycles; ++cycle) {
        for (const Step& step : steps) {
            time += step.duration;
            advance += step.advance;
            keys.push_back({time, {start + advance * direction, rotation}});
        }
    }
    return keys;
}

std::vector<RecordedHand::Key> read_keys(const Setup& setup) {
    const Parameters& parameters = setup.parameters;
    if (parameters.has("file") && parameters.has("motion"))
        throw Error("motion", "found both file and motion, wanted exactly one of them");
    if (parameters.has("motion")) return keys_of_motion(parameters, setup.needle->length);
    if (!parameters.has("file")) throw Error("found neither file nor motion, wanted exactly one of them");
    for (const char* key : {"tip_start", "direction", "cycles"}) {
        if (parameters.has(key)) throw Error(key, "belongs to a motion, and this hand follows a file");
    }
    return read_pose_file(parameters.text("file"));
}

}    // namespace

RecordedHand::RecordedHand(const Setup& setup) : keys_(read_keys(setup)) {}

/// Those of the paper's device, a Phantom Premium 1.5 with six degrees of freedom, so that a recorded run is limited like a felt
/// one.
DeviceLimits RecordedHand::limits() const {
    return {
        .force = 8.5,           // its largest force
        .moment = 0.515,        // its largest torque in yaw and pitch, quoted from memory: check before it drives a motor
        .force_rate = 800.0,    // the stiffest wall it shows (0.8 N/mm) met at 1 m/s; insertions peak at 0.3 m/s
        .soft_start = 0.2,      // the time that a person needs to answer a force
        .stale_after = 5e-3,    // five readings of a loop at 1 kHz
        .ramp_down = 0.02,      // too fast to push with, too slow to be a kick
    };
}

Reading RecordedHand::read(double time) {
    const auto after =
        std::upper_bound(keys_.begin(), keys_.end(), time, [](double wanted, const Key& key) { return wanted < key.time; });
    if (after == keys_.begin()) return {.pose = keys_.front().pose};
    if (after == keys_.end()) return {.pose = keys_.back().pose};
    const Key& from = *std::prev(after);
    const double fraction = (time - from.time) / (after->time - from.time);
    return {.pose = {from.pose.position + fraction * (after->pose.position - from.pose.position),
                     from.pose.rotation.slerp(fraction, after->pose.rotation).normalized()}};
}

namespace {

constexpr Parameter step_fields[] = {
    optional(number("insert", "m", positive, "how far the hand pushes along the direction of insertion")),
    optional(number("withdraw", "m", positive, "how far the hand pulls back")),
    optional(number("hold", "s", positive, "how long the hand keeps still")),
    optional(number("speed", "m/s", positive, "of insert and withdraw; left out with hold")),
};

constexpr Parameter parameters[] = {
    optional(
        file("file", "a CSV of base poses with the header `time [s],x [m],y [m],z [m],qw,qx,qy,qz`; left out: motion is given")),
    optional(records("motion", step_fields, "steps one after the other, each insert, withdraw or hold; left out: file is given")),
    optional(vector3("tip_start", "m", "where the tip is at time 0; wanted with motion")),
    optional(vector3("direction", "1", "of insertion, of any length but zero; left out: straight down")),
    optional(integer("cycles", {.least = 1, .greatest = 100000}, "how many times the motion runs; left out: once")),
};

}    // namespace
}    // namespace stylet::recorded_hand

STYLET_PLUGIN(stylet::recorded_hand::RecordedHand, "recorded_hand", stylet::recorded_hand::parameters,
              .summary = "A hand that repeats a file of poses or a motion written in the scene",
              .formula = "x(t) = x_i + s (x_i+1 - x_i),  q(t) = slerp(q_i, q_i+1, s),  s = (t - t_i)/(t_i+1 - t_i)",
              .source = "Shoemake 1985, slerp between poses; the limits are those of a Phantom Premium 1.5",
              .validity = "A recording doesn't yield: what the hand would have done under another force is not known")
