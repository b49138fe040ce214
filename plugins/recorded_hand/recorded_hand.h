#pragma once

#include <stylet/haptic_device.h>

#include <vector>

namespace stylet::recorded_hand {

/// A hand that repeats a recording: a CSV file of base poses, or a motion written in the scene.
///
///     between two rows: position linear in time, rotation by slerp; before the first and after the last row: held
///
/// Source: Shoemake 1985 for slerp. A motion moves the tip from `tip_start` along `direction`; the base is one needle length
/// behind. Leaves out the hand's own compliance: whatever force it is given, it goes where the recording says.
class RecordedHand final : public HapticDevice {
public:
    /// A pose of the base and when it is reached.
    struct Key {
        double time;    // [s]
        Pose pose;
    };

    explicit RecordedHand(const Setup& setup);

    DeviceLimits limits() const override;
    Reading read(double time) override;
    void write(const Wrench&) override {}    // a recording does not yield; core's recorder keeps the wrench
    double duration() const override { return keys_.back().time; }

private:
    std::vector<Key> keys_;    // at least one; times rise strictly
};

}    // namespace stylet::recorded_hand
