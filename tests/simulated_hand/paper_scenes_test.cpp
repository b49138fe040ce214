// The paper's scenes held by a simulated hand: calm through buckling and rupture, whoever holds the needle. Pass as in the
// reference's "Haptic stability, offline".
#include "tests/simulated_hand/port.h"
#include "tests/simulated_hand/ripple.h"

#include <gtest/gtest.h>

#include <cmath>

namespace stylet::simulated_hand {
namespace {

using whole_scenes::Happening;
using whole_scenes::measured;
using whole_scenes::Overrides;
using whole_scenes::paper_scene;
using whole_scenes::play;
using whole_scenes::Trace;

constexpr double dt = 1e-3;           // [s] of these scenes
constexpr double rounding = 1e-12;    // [J] of sums of 50 mJ
constexpr double passive = -1e-6;     // [J] the reference's bound for the observer
// [N] A hundredth of what is felt here, where a hand tells a tenth. A shaft that sticks while the hand still swings after a
// rupture leaves 6 mN; the position's quanta against the tissue 0.2 mN.
constexpr double calm = 0.01;
// [N/s] A shaft that sticks is as stiff as 1 kN/m, and a hand turns back on it at 40 mm/s: 39 N/s were measured. Pushing at 10
// mm/s it is 0.6, where a quantum of the position is passed. The force chain would let 800 go through.
constexpr double gentle = 60.0;

std::filesystem::path prepared(const std::string& name) {
    return std::filesystem::path(SCENE_FOLDER) / "mock" / (name + ".yaml");
}

/// Largest change of the device's force from tick to tick [N/s], leaving out the ticks of a declared rupture.
double force_rate(const Trace& trace) {
    double most = 0.0;
    for (std::size_t k = 1; k < trace.samples.size(); ++k) {
        const bool ruptured = std::ranges::any_of(
            trace.events, [k](const Happening& event) { return event.tick == k && event.name == "punctured"; });
        const double change = std::abs(trace.samples[k].device_force - trace.samples[k - 1].device_force) / dt;
        if (!ruptured) most = std::max(most, change);
    }
    return most;
}

/// Calm for any hand, whatever it does.
Port expect_calm(const Trace& trace, const Grip& grip) {
    const Port port = port_of(trace, grip, dt);
    const double ripple = sustained_ripple(device_forces(trace), dt), rate = force_rate(trace);
    measured("given_to_the_simulation", port.given, "J");
    measured("least_given", port.least_given, "J");
    measured("least_of_the_simulation", port.least_of_simulation, "J");
    measured("sustained_ripple", ripple, "N");
    measured("force_rate", rate, "N/s");
    EXPECT_NEAR(port.given, trace.samples.back().port_energy, rounding) << "core's observer sees the same";
    EXPECT_GE(port.least_of_simulation, passive);
    EXPECT_GE(port.least_felt, passive);
    EXPECT_LE(ripple, calm);
    EXPECT_LE(rate, gentle);
    EXPECT_EQ(trace.count("not converged"), 0U);
    whole_scenes::expect_sound(trace);
    return port;
}

using SceneAndGrip = std::tuple<const char*, Grip>;
class PaperScene : public testing::TestWithParam<SceneAndGrip> {};

TEST_P(PaperScene, StaysCalmThroughBucklingAndRupture) {
    const auto& [scene, grip] = GetParam();
    const Trace trace = play(paper_scene(scene), held_by(grip));
    print_events(trace);
    EXPECT_GE(expect_calm(trace, grip).least_given, passive);
}

/// And out again. A force that is held between ticks is too small on the way in and too great on the way out: what is elastic
/// gives back more than it got, up to 26 µJ here. The simulation's own work doesn't, and the device takes what the hold gives,
/// and more. (The hand waits first: the soft start makes energy too, where it fades in a force that is already there.)
TEST_P(PaperScene, StaysCalmThereAndBack) {
    const auto& [scene, grip] = GetParam();
    Overrides overrides = held_by(grip);
    overrides.push_back(
        {"device.motion", "[{hold: 0.3 s}, {insert: 80 mm, speed: 20 mm/s}, {hold: 0.5 s}, {withdraw: 80 mm, speed: 40 mm/s}]"});
    const Trace trace = play(paper_scene(scene), overrides);
    print_events(trace);
    (void)expect_calm(trace, grip);
}

std::string name_of(const testing::TestParamInfo<SceneAndGrip>& info) {
    return std::string(std::get<0>(info.param)) + "_" + std::get<1>(info.param).name;
}

INSTANTIATE_TEST_SUITE_P(HeldBy, PaperScene,
                         testing::Combine(testing::Values("fig10a_l150", "fig10a_l200", "fig10a_l300", "fig10b_r025",
                                                          "fig10b_r030", "fig10b_r035", "fig10b_r040", "fig9"),
                                          testing::ValuesIn(grips)),
                         name_of);

/// A hand that pushes against a spring K with F moves at v k/(k + K), and lags by (F + F_c + b x' − b_hand (v − x'))/k.
TEST(SimulatedHand, RupturesTheSurfaceLaterTheSofterItIs) {
    constexpr double speed = 10e-3;                                          // [m/s] v
    constexpr double surface = 2.0 * 0.3e-3 * 25e3 / (1.0 - 0.49 * 0.49);    // [N/m] K of the tip on the gel, 2aE/(1 − ν²)
    constexpr double read = 3e-3;                                            // [s] half a quantum takes 2 ms, and a tick
    const double recorded = play(paper_scene("fig10a_l150")).first("punctured")->time;
    for (const Grip& grip : grips) {
        const Happening punctured = *play(paper_scene("fig10a_l150"), held_by(grip)).first("punctured");
        const double moves = speed * grip.hand_stiffness / (grip.hand_stiffness + surface);    // [m/s] x'
        const double resists = punctured.hand_force + grip.coulomb_friction + grip.device_damping * moves -
                               grip.hand_damping * (speed - moves);    // [N]
        const double late = punctured.time - recorded;
        measured(grip.name + "_late", late, "s");
        EXPECT_NEAR(late, resists / grip.hand_stiffness / speed, read) << grip;
    }
}

/// A rupture lets go a part of what the hand holds against; that much over its stiffness it surges.
TEST(SimulatedHand, SurgesInAsTheSurfaceRuptures) {
    const Trace trace = play(prepared("surge"));
    print_events(trace);
    const Happening& punctured = *trace.first("punctured");
    const auto at = [&](double later) { return trace.samples[punctured.tick + static_cast<std::size_t>(later / dt)]; };
    const double surge = at(0.2).travel - punctured.travel - 0.2 * 10e-3;
    measured("surge", surge, "m");
    EXPECT_GT(surge, 2e-3);
    EXPECT_LT(surge, 1.0 / 100.0) << "no more than the hand was pressed back";
}

TEST(PreparedScene, IsCalm) {
    const Grip soft{"Surge", 0.075, 0.1, 0.2, 5.0, 100.0}, middling{"Fig9", 0.075, 0.1, 0.2, 5.0, 300.0};
    (void)expect_calm(play(prepared("surge")), soft);
    (void)expect_calm(play(prepared("fig9")), middling);
}

}    // namespace
}    // namespace stylet::simulated_hand
