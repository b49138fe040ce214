// A wall that only pushes, met in four ways by a hand that pays for nothing but what passes through its device: for which
// stiffness, damping, delay and rate is wall and device together passive? Colgate and Schenkel 1997: where b ≥ K T (½ + delay).
#include "tests/simulated_hand/port.h"
#include "tests/simulated_hand/ripple.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <numbers>
#include <span>

namespace stylet::simulated_hand {
namespace {

using whole_scenes::Overrides;
using whole_scenes::own_scene;
using whole_scenes::play;
using whole_scenes::Trace;

/// What the hand wants to do, from half a millimetre above the wall, once the soft start is over.
struct Input {
    const char* name;
    std::string motion;
};

std::string way(double distance, double duration) {
    char text[80];
    std::snprintf(text, sizeof text, "{%s: %.9g m, speed: %.9g m/s}, ", distance > 0.0 ? "insert" : "withdraw",
                  std::abs(distance), std::abs(distance) / duration);
    return text;
}

std::string sine() {
    constexpr int per_period = 40;
    constexpr double amplitude = 1.5e-3, frequency = 4.0;    // [m], [Hz]
    std::string motion = "[{hold: 0.3 s}, " + way(2e-3, 0.1);
    for (int i = 0; i < 3 * per_period; ++i) {
        const auto height = [](int step) { return amplitude * std::sin(2.0 * std::numbers::pi * step / per_period); };
        motion += way(height(i + 1) - height(i), 1.0 / (frequency * per_period));
    }
    return motion + "{hold: 0.4 s}]";
}

std::string tap() {
    std::string motion = "[{hold: 0.3 s}, ";
    for (int i = 0; i < 5; ++i) motion += way(2e-3, 0.02) + "{hold: 0.05 s}, " + way(-2e-3, 0.02) + "{hold: 0.05 s}, ";
    return motion + "{hold: 0.4 s}]";
}

const Input inputs[] = {
    {"sine", sine()},
    {"step", "[{hold: 0.3 s}, " + way(2e-3, 0.004) + "{hold: 0.4 s}]"},
    {"tap", tap()},
    {"release", "[{hold: 0.3 s}, " + way(3e-3, 0.15) + "{hold: 0.3 s}, " + way(-3e-3, 0.003) + "{hold: 0.4 s}]"}};

struct Combination {
    double stiffness;    // [N/m] of the wall
    double damping;      // [N·s/m] of the device
    double rate;         // [Hz]
    int delay;           // [ticks]

    /// The damping [N·s/m] that makes up for what the hold and the delay give: from x_k−d ≥ x_k − |Δx| − … and Cauchy and
    /// Schwarz, Σ F Δx ≥ −(½ + d) K Σ Δx².
    [[nodiscard]] double wanted_damping() const { return stiffness / rate * (0.5 + delay); }
    [[nodiscard]] bool promised() const { return damping >= wanted_damping(); }
};

/// The worst of the four inputs.
struct Outcome {
    double least_felt = 0.0;    // [J] of what the hand has put into wall and device
    double least_owed = 0.0;    // [J] the same, were the device's damping just what is wanted
    double ringing = 0.0;       // [N] ripple that is left at the end, when the hand has kept still for a while
};

Outcome worst_of_inputs(const Combination& with) {
    Grip grip{"Middling", 0.075, with.damping, 0.2, 3.0, 300.0, 0.0, 0.0, with.delay};
    char modulus[40], rate[40];
    std::snprintf(modulus, sizeof modulus, "%.17g Pa", with.stiffness / 0.8e-3);    // E = K/2a
    std::snprintf(rate, sizeof rate, "%.17g Hz", with.rate);
    Outcome worst;
    for (const Input& input : inputs) {
        Overrides overrides = held_by(grip);
        overrides.insert(overrides.end(),
                         {{"device.motion", input.motion}, {"tissue.layers[0].youngs_modulus", modulus}, {"run.rate", rate}});
        const Trace trace = play(own_scene("wall"), overrides);
        whole_scenes::expect_sound(trace);
        Grip wanted = grip;
        wanted.device_damping = with.wanted_damping();
        worst.least_felt = std::min(worst.least_felt, port_of(trace, grip, 1.0 / with.rate).least_felt);
        worst.least_owed = std::min(worst.least_owed, port_of(trace, wanted, 1.0 / with.rate).least_felt);
        const std::vector<double> forces = device_forces(trace);
        const auto last = static_cast<std::size_t>(window * with.rate);
        worst.ringing = std::max(worst.ringing, ripple(std::span(forces).last(last), 1.0 / with.rate));
    }
    return worst;
}

class Sweep : public testing::TestWithParam<double> {};

TEST_P(Sweep, IsPassiveWhereTheoryPromisesIt) {
    constexpr double rounding = -1e-12;    // [J] of sums of a few mJ
    std::printf(
        "  %g Hz: least energy [µJ] that the hand had put in, over sine, step, tap and release; in brackets the ripple [mN]\n",
        GetParam());
    std::printf("  that is left once it keeps still; * promised\n  wall [N/m]  device [N s/m]");
    for (const int delay : {0, 1, 3}) std::printf("%11d ticks late   ", delay);
    std::printf("\n");
    int promised = 0, active = 0;
    for (const double stiffness : {100.0, 1000.0, 3000.0}) {
        for (const double damping : {0.01, 0.1, 1.0, 5.0}) {
            std::printf("  %10g  %14g", stiffness, damping);
            for (const int delay : {0, 1, 3}) {
                const Combination with{stiffness, damping, GetParam(), delay};
                const Outcome outcome = worst_of_inputs(with);
                std::printf("  %10.3g (%8.3g)%s", 1e6 * outcome.least_felt, 1e3 * outcome.ringing, with.promised() ? "*" : " ");
                EXPECT_GE(outcome.least_owed, rounding) << "more than the hold and the delay explain";
                if (with.promised()) {
                    EXPECT_GE(outcome.least_felt, rounding);
                }
                promised += with.promised();
                active += outcome.least_felt < rounding;
            }
            std::printf("\n");
        }
    }
    EXPECT_GT(promised, 0) << "or nothing was tested";
    EXPECT_GT(active, 0) << "or no combination is beyond the bound";
}

INSTANTIATE_TEST_SUITE_P(Rate, Sweep, testing::Values(1000.0, 200.0),
                         [](const auto& rate) { return std::to_string(static_cast<int>(rate.param)) + "Hz"; });

}    // namespace
}    // namespace stylet::simulated_hand
