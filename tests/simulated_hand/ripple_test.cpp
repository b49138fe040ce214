#include "tests/simulated_hand/ripple.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace stylet::simulated_hand {
namespace {

constexpr double dt = 1e-3;    // [s]

/// A force that rises steadily and swings at the frequency [Hz], for a while in the middle only.
std::vector<double> swinging(double frequency, double from = 0.0, double to = 2.0) {
    std::vector<double> signal;
    for (double time = 0.0; time < 2.0; time += dt) {
        const bool now = time >= from && time < to;
        signal.push_back(1.0 + 5.0 * time + (now ? std::sin(2.0 * std::numbers::pi * frequency * time + 0.3) : 0.0));
    }
    return signal;
}

constexpr double root_mean_square = 1.0 / std::numbers::sqrt2;    // of a sine of amplitude 1
constexpr double window_leak = 1e-2;                              // of the sine: the Hann window's skirts

TEST(Ripple, OfASineIsItsRootMeanSquare) {
    for (const double frequency : {33.0, 50.0, 123.0, 250.0, 444.0}) {
        EXPECT_NEAR(sustained_ripple(swinging(frequency), dt), root_mean_square, window_leak) << frequency << " Hz";
    }
}

TEST(Ripple, LeavesTheHandsOwnSwingOut) {
    EXPECT_LE(sustained_ripple(swinging(5.0), dt), window_leak);
}

TEST(Ripple, OfASteadyRiseIsNothing) {
    EXPECT_LE(sustained_ripple(swinging(0.0), dt), 1e-12);
}

TEST(Ripple, IsSustainedFromTwoWindowsOn) {
    EXPECT_LE(sustained_ripple(swinging(100.0, 0.8, 1.0), dt), window_leak);
    EXPECT_NEAR(sustained_ripple(swinging(100.0, 0.8, 1.2), dt), root_mean_square, window_leak);
}

}    // namespace
}    // namespace stylet::simulated_hand
