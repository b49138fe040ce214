#include "recorded_hand.h"

#include "pose_file.h"

#include <stylet/phantom_premium.h>

namespace stylet::recorded_hand {
namespace {

PosePath read_path(const Setup& setup) {
    const Parameters& parameters = setup.parameters;
    if (parameters.has("file") && parameters.has("motion"))
        throw Error("motion", "found both file and motion, wanted exactly one of them");
    if (parameters.has("motion")) return read_motion(parameters, setup.needle->length);
    if (!parameters.has("file")) throw Error("found neither file nor motion, wanted exactly one of them");
    for (const char* key : {"tip_start", "direction", "cycles"}) {
        if (parameters.has(key)) throw Error(key, "belongs to a motion, and this hand follows a file");
    }
    return PosePath(read_pose_file(parameters.text("file")));
}

}    // namespace

RecordedHand::RecordedHand(const Setup& setup) : path_(read_path(setup)) {}

DeviceLimits RecordedHand::limits() const {
    return phantom_premium;
}

namespace {

constexpr Parameter parameters[] = {
    optional(
        file("file", "a CSV of base poses with the header `time [s],x [m],y [m],z [m],qw,qx,qy,qz`; left out: motion is given")),
    optional(records("motion", motion_step, "steps one after the other, each insert, withdraw or hold; left out: file is given")),
    optional(vector3("tip_start", "m", "where the tip is at time 0; wanted with motion")),
    motion_direction,
    motion_cycles,
};

}    // namespace
}    // namespace stylet::recorded_hand

STYLET_PLUGIN(stylet::recorded_hand::RecordedHand, "recorded_hand", stylet::recorded_hand::parameters,
              .summary = "A hand that repeats a file of poses or a motion written in the scene",
              .formula =
                  "x(t) = x_i + s (x_i+1 - x_i), q(t) = slerp(q_i, q_i+1, s), s = (t - t_i)/(t_i+1 - t_i)\n"
                  "before the first pose and after the last it holds still",
              .source = "Shoemake 1985, slerp between poses; the limits are those of a Phantom Premium 1.5",
              .validity =
                  "A recording doesn't yield: whatever force it is given, it goes where it went. What the hand would have done "
                  "under another force is not known")
