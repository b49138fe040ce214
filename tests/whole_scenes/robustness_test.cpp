// Rough hands and rough scenes: nothing may crash, run away or make energy.
#include "tests/whole_scenes/trace.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace stylet::whole_scenes {
namespace {

constexpr double length = 0.1;    // [m] of the needle in driven.yaml

// [of the peak work] Contact frames stand still for a step: 30° in the 64 steps that one tick is split into leaks 3.6e-3.
constexpr double whirling_books = 5e-3;
// The mouth's force on a bowed needle lags a step, so its books close to the first order of the tick: 1.2e-3 was measured at 100
// Hz.
constexpr double slow_books = 2e-3;

// [N] What a rod still rings with 0.1 s later: 5e-6 was measured of 10 N.
constexpr double ringing = 1e-4;

/// Whatever happens, it is finite, within the device's limit and named, and the books close to `residual`.
void expect_survived(const Trace& trace, double residual = sound_residual) {
    print_events(trace);
    measured("residual", trace.relative);
    measured("released", trace.samples.back().released, "J");
    double made =
        0.0;    // [J] by a body's integrator: a rod jerked at 50 m/s turns its edges by a good part of a radian in a step
    for (const core::Sample& sample : trace.samples) made = std::max(made, -sample.numerical);
    measured("made_by_the_integrator", made / trace.peak_work);
    EXPECT_LE(made, sound_residual * trace.peak_work);
    measured("not_converged", static_cast<double>(trace.count("not converged")));
    measured("peak_hand_force", trace.peak_hand_force(), "N");
    expect_sound(trace, residual);
}

class RoughHand : public testing::TestWithParam<const char*> {
protected:
    [[nodiscard]] static Overrides needle() {
        Overrides overrides{{"needle.type", GetParam()}};
        if (GetParam() == std::string("beam_column")) overrides.push_back({"needle.buckling", "{type: euler}"});
        return overrides;
    }
    [[nodiscard]] static bool is_rod() { return GetParam() == std::string("rod"); }
    [[nodiscard]] static Trace drive(const Motion& motion, std::size_t ticks) {
        Stage stage(own_scene("driven"), needle(), motion);
        Trace trace = play(stage, ticks);
        EXPECT_LE(stage.hand().greatest_force, DrivenHand::device_limits.force * (1.0 + 1e-12)) << "in any direction";
        return trace;
    }
};

TEST_P(RoughHand, JumpsInByFiftyMillimetresInOneTick) {
    const Trace trace = drive([](double time) { return tip_at(time < 0.05 ? -1e-3 : 49e-3, length); }, 200);
    expect_survived(trace);
    EXPECT_EQ(trace.count("punctured"), 1u);
}

TEST_P(RoughHand, JumpsOutByFiftyMillimetresInOneTick) {
    const Motion motion = [](double time) {
        return tip_at(time < 0.4 ? -1e-3 + 0.1 * time : time < 0.5 ? 39e-3 : -11e-3, length);
    };
    const Trace trace = drive(motion, 600);
    expect_survived(trace);
    EXPECT_NEAR(trace.samples.back().hand_force, 0.0, is_rod() ? ringing : 1e-9);
}

TEST_P(RoughHand, JumpsBackAndForthEveryTick) {
    const Motion motion = [](double time) {
        return tip_at(static_cast<long>(std::lround(time * 1e3)) % 2 == 0 ? -25e-3 : 25e-3, length);
    };
    expect_survived(drive(motion, 300));
}

/// Thirty degrees about the base while the tip is 39 mm deep, in `turn` seconds.
Motion turned(double turn) {
    return [turn](double time) {
        Pose pose = tip_at(std::min(-1e-3 + 0.1 * time, 39e-3), length);
        const double angle = std::numbers::pi / 6.0 * std::clamp((time - 0.45) / turn, 0.0, 1.0);
        pose.rotation = Quaternion(Eigen::AngleAxisd(angle, Vector3::UnitY()));
        return pose;
    };
}

TEST_P(RoughHand, TurnsByThirtyDegreesWhileInserted) {
    expect_survived(drive(turned(0.3), 900));
}

TEST_P(RoughHand, TurnsByThirtyDegreesInOneTickWhileInserted) {
    expect_survived(drive(turned(1e-3), 600), whirling_books);
}

/// In circles of 5 mm, sideways and along the needle, either way round.
Motion circling(double sense) {
    return [sense](double time) {
        const double begin = 0.5, angle = 4.0 * std::numbers::pi * std::max(0.0, time - begin);
        Pose pose = tip_at(std::min(-1e-3 + 0.1 * time, 29e-3) + sense * 5e-3 * std::sin(angle), length);
        pose.position.x() = 5e-3 * (std::cos(angle) - 1.0);
        return pose;
    };
}

TEST_P(RoughHand, CirclesInsideTheTissue) {
    for (const double sense : {1.0, -1.0}) expect_survived(drive(circling(sense), 2500));
}

/// Once 39 mm in and back to 29 mm; then again and again 2 mm aside, 10 mm deeper in its own track, back to the middle, and out.
Motion pumping(double sense) {
    return [sense](double time) {
        const double begin = 0.6, period = 0.4, quarter = 0.1;
        if (time < begin) return tip_at(time < 0.4 ? -1e-3 + 0.1 * time : std::max(39e-3 - 0.1 * (time - 0.4), 29e-3), length);
        double phase = std::fmod(time - begin, period) / quarter;
        if (sense < 0.0) phase = 4.0 - phase;
        const double aside = std::clamp(phase, 0.0, 1.0) - std::clamp(phase - 2.0, 0.0, 1.0);
        const double deeper = std::clamp(phase - 1.0, 0.0, 1.0) - std::clamp(phase - 3.0, 0.0, 1.0);
        Pose pose = tip_at(29e-3 + 10e-3 * deeper, length);
        pose.position.x() = 2e-3 * aside;
        return pose;
    };
}

TEST_P(RoughHand, PumpsNoEnergyOutOfTheTissue) {
    for (const double sense : {1.0, -1.0}) {
        const Trace trace = drive(pumping(sense), 600 + 10 * 400);
        expect_survived(trace);
        const double first = trace.samples[600 + 400].hand_work, last = trace.samples[600 + 9 * 400].hand_work;
        measured("work_of_eight_cycles", last - first, "J");
        EXPECT_GE(last - first, 0.0) << "the hand must never gain by a cycle";
    }
}

TEST_P(RoughHand, PushesAtOneMetreASecond) {
    expect_survived(drive([](double time) { return tip_at(std::min(-1e-3 + time, 0.06), length); }, 200));
}

TEST_P(RoughHand, ComesInAtASlant) {
    const Motion motion = [](double time) {
        const Vector3 direction = Vector3(1.0, 0.0, -1.0).normalized();
        return Pose{.position = (-length - 1e-3 + 0.1 * std::min(time, 0.4)) * direction,
                    .rotation = Quaternion::FromTwoVectors(-Vector3::UnitZ(), direction)};
    };
    const Trace trace = drive(motion, 600);
    expect_survived(trace);
    EXPECT_EQ(trace.count("punctured"), 1u);
}

INSTANTIATE_TEST_SUITE_P(Needle, RoughHand, testing::Values("rigid", "beam_column", "elastica", "rod"),
                         [](const auto& needle) { return std::string(needle.param); });

const core::Override contrast_of_a_thousand{"tissue.layers",
                                            "[{name: skin, youngs_modulus: 2500 kPa, poisson_ratio: 0.49, thickness: 3 mm},"
                                            " {name: fat, youngs_modulus: 2.5 kPa, poisson_ratio: 0.49, thickness: 20 mm},"
                                            " {name: organ, youngs_modulus: 25 kPa, poisson_ratio: 0.49}]"};

class RoughScene : public testing::TestWithParam<const char*> {};

TEST_P(RoughScene, RunsWithContactsTwoMillimetresApart) {
    expect_survived(play(paper_scene(GetParam()), {{"coupling.contact_spacing", "2 mm"}}));
}

TEST_P(RoughScene, RunsWithContactsTwentyMillimetresApart) {
    expect_survived(play(paper_scene(GetParam()), {{"coupling.contact_spacing", "20 mm"}}));
}

TEST_P(RoughScene, RunsThroughLayersAThousandTimesStiffer) {
    const core::Override everywhere{
        "effects", "[{type: fracture, rupture_force: 1 N, toughness: 164 J/m^2}, {type: friction, per_length: 25 N/m}]"};
    expect_survived(play(paper_scene(GetParam()), {contrast_of_a_thousand, everywhere}));
}

TEST_P(RoughScene, RunsATenthAsOften) {
    expect_survived(play(paper_scene(GetParam()), {{"run.rate", "100 Hz"}}), slow_books);
}

INSTANTIATE_TEST_SUITE_P(Paper, RoughScene, testing::Values("fig10a_l150", "fig9"),
                         [](const auto& scene) { return std::string(scene.param); });

TEST(BowedRupture, ClosesItsBooksAtOtherForcesAndRadii) {
    // Further bowed the books get worse: 9.8e-4 was measured at 0.69 N, 1.3e-3 at 0.70 N, where the slope nears 45°.
    for (const char* force : {"0.65 N", "0.67 N", "0.68 N"}) {
        expect_survived(play(paper_scene("fig9"), {{"effects[0].rupture_force", force}}));
    }
    expect_survived(play(paper_scene("fig9"), {{"effects[0].rupture_force", "0.34 N"}, {"needle.radius", "0.25 mm"}}));
}

TEST(BeginningInTheTissue, IsBroughtThereBeforeTheBooksOpen) {
    for (const char* needle : {"beam_column", "elastica", "rod"}) {
        const Trace trace =
            play(paper_scene("fig10a_l150"), {{"device.tip_start", "[0 mm, 0 mm, -60 mm]"}, {"needle.type", needle}});
        expect_survived(trace);
        EXPECT_EQ(trace.count("punctured"), 1u);
        measured("kinetic", trace.samples.front().kinetic, "J");
        EXPECT_LE(std::abs(trace.samples.front().kinetic), 1e-6) << "it comes in at rest";
    }
}

TEST(ContactSpacing, OfAMillimetreRunsInAShortNeedle) {
    expect_survived(play(
        own_scene("driven"), {{"coupling.contact_spacing", "1 mm"}, {"needle.length", "60 mm"}},
        [](double time) { return tip_at(std::min(-1e-3 + 0.1 * time, 50e-3), 0.06); }, 600));
}

}    // namespace
}    // namespace stylet::whole_scenes
