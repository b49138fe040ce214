// A device whose pose stops being a number: what a broken cable does.
#include <stylet/haptic_device.h>

#include <limits>

namespace {

class LostHand final : public stylet::HapticDevice {
public:
    explicit LostHand(const stylet::Setup& setup) : length_(setup.needle->length) {}

    stylet::DeviceLimits limits() const override {
        return {.force = 3.0, .moment = 0.1, .force_rate = 1e3, .soft_start = 0.01, .stale_after = 0.01, .ramp_down = 0.01};
    }
    stylet::Reading read(double time) override {
        constexpr double lost = 0.05;    // [s]
        const double height = time < lost ? length_ : std::numeric_limits<double>::quiet_NaN();
        return {.pose = {.position = {0.0, 0.0, height}}};
    }
    void write(const stylet::Wrench&) override {}
    double duration() const override { return 0.1; }

private:
    double length_;    // [m]
};

}    // namespace

STYLET_PLUGIN(LostHand, "lost_hand", stylet::no_parameters, .summary = "A hand whose pose stops being a number",
              .formula = "none", .source = "none", .validity = "tests")
