// One motion at 500, 1000 and 2000 Hz: what the hand feels may not depend on the rate.
#include "tests/whole_scenes/trace.h"

#include <gtest/gtest.h>

#include <cmath>

namespace stylet::whole_scenes {
namespace {

constexpr double most_difference = 2e-3;    // RMS over the peak force: the bound
constexpr double event_margin = 6e-3;    // [s] around each event: three of the slowest ticks, for an event that falls in another

Trace at_rate(const std::string& scene, int rate) {
    return play(paper_scene(scene), {{"run.rate", std::to_string(rate) + " Hz"}});
}

bool near_event(const Trace& trace, double time) {
    return std::ranges::any_of(trace.events, [&](const Happening& event) { return std::abs(event.time - time) <= event_margin; });
}

/// RMS of the difference of the hand's force, at the slow run's ticks, over the fast run's peak force.
double difference(const Trace& slow, const Trace& fast, std::size_t ratio) {
    double squares = 0.0;
    std::size_t counted = 0;
    for (std::size_t tick = 0; tick < slow.samples.size(); ++tick) {
        const core::Sample &a = slow.samples[tick], &b = fast.samples[ratio * (tick + 1) - 1];
        EXPECT_DOUBLE_EQ(a.time, b.time);
        if (near_event(slow, a.time) || near_event(fast, a.time)) continue;
        squares += (a.hand_force - b.hand_force) * (a.hand_force - b.hand_force);
        ++counted;
    }
    return std::sqrt(squares / static_cast<double>(counted)) / fast.peak_hand_force();
}

class Rates : public testing::TestWithParam<const char*> {};

TEST_P(Rates, GiveTheSameForce) {
    const Trace slow = at_rate(GetParam(), 500), usual = at_rate(GetParam(), 1000), fast = at_rate(GetParam(), 2000);
    ASSERT_EQ(2 * slow.samples.size(), usual.samples.size());
    ASSERT_EQ(2 * usual.samples.size(), fast.samples.size());
    EXPECT_EQ(slow.names(), fast.names());
    EXPECT_EQ(usual.names(), fast.names());
    const double slow_fast = difference(slow, fast, 4), usual_fast = difference(usual, fast, 2),
                 slow_usual = difference(slow, usual, 2);
    measured("rms_500_2000", slow_fast);
    measured("rms_1000_2000", usual_fast);
    measured("rms_500_1000", slow_usual);
    EXPECT_LE(slow_fast, most_difference);
    EXPECT_LE(usual_fast, most_difference);
    EXPECT_LE(slow_usual, most_difference);
    for (const Trace* trace : {&slow, &usual, &fast}) {
        measured("residual", trace->relative);
        expect_sound(*trace);
    }
}

INSTANTIATE_TEST_SUITE_P(Paper, Rates, testing::Values("fig10a_l150", "fig9"),
                         [](const auto& scene) { return std::string(scene.param); });

}    // namespace
}    // namespace stylet::whole_scenes
