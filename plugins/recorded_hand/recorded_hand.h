#pragma once

#include <stylet/hand_motion.h>
#include <stylet/haptic_device.h>

namespace stylet::recorded_hand {

/// A hand that repeats a recording: a CSV file of base poses, or a motion written in the scene. Straight ways in between
/// (PosePath). Leaves out the hand's own compliance: whatever force it is given, it goes where the recording says. Limited like
/// the paper's device, so that a recorded run is limited like a felt one.
class RecordedHand final : public HapticDevice {
public:
    explicit RecordedHand(const Setup& setup);

    DeviceLimits limits() const override;
    Reading read(double time) override { return {.pose = path_.at(time)}; }
    void write(const Wrench&) override {}    // a recording does not yield; core's recorder keeps the wrench
    double duration() const override { return path_.end(); }

private:
    PosePath path_;
};

}    // namespace stylet::recorded_hand
