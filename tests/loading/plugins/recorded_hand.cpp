#include <stylet/haptic_device.h>

namespace {

class RecordedHand : public stylet::HapticDevice {
public:
    explicit RecordedHand(const stylet::Setup& setup) : steps_(setup.parameters.has("motion")) {
        if (!steps_ && !setup.parameters.has("file")) throw stylet::Error("file", "found neither a file nor a motion");
    }
    stylet::DeviceLimits limits() const override { return {10.0, 1.0, 100.0, 0.1, 0.01, 0.02}; }
    stylet::Reading read(double) override { return {}; }
    void write(const stylet::Wrench&) override {}

private:
    bool steps_;
};

constexpr stylet::Parameter steps[] = {
    stylet::choice("way", "insert hold withdraw", "what the hand does"),
    stylet::number("speed", "m/s", stylet::positive, "speed of the base"),
    stylet::optional(stylet::integer("times", {.least = 1, .greatest = 1000}, "repetitions; left out, once")),
};
constexpr stylet::Parameter parameters[] = {
    stylet::optional(stylet::file("file", "a table of poses; left out, the motion counts")),
    stylet::optional(stylet::records("motion", steps, "what the hand does, in turn")),
};

}    // namespace

STYLET_PLUGIN(RecordedHand, "recorded_hand", parameters, .summary = "A device for tests", .formula = "none", .source = "none",
              .validity = "tests")
