// A needle into bovine liver, beside what was measured there (reference: Okamura, Simone and O'Leary 2004; Gokgol et al. 2012).
#include "tests/whole_scenes/trace.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace stylet::whole_scenes {
namespace {

const std::filesystem::path scene = std::filesystem::path(SCENE_FOLDER) / "liver/bovine_liver.yaml";

Overrides with_needle(const std::string& type) {
    return {{"needle.type", type}};
}

Overrides meshed(const std::string& cells) {
    return {{"tissue.type", "corotational_fem"}, {"tissue.corotational_fem.cells", cells}};
}

/// Dent [m] under a force [N] on the capsule: F = a₁x + a₂x² with Okamura's means.
double measured_dent(double force) {
    constexpr double a1 = 2.0, a2 = 2300.0;    // [N/m], [N/m²]
    return (std::sqrt(a1 * a1 + 4.0 * a2 * force) - a1) / (2.0 * a2);
}

/// From the tick after the puncture until the hand first rests.
struct Insertion {
    std::size_t first, end;
};

Insertion insertion_of(const Trace& trace) {
    const std::size_t first = trace.first("punctured")->tick + 1;
    std::size_t end = first;
    while (end + 1 < trace.samples.size() && trace.samples[end + 1].travel > trace.samples[end].travel) ++end;
    return {first, end};
}

TEST(BovineLiver, ItsCapsuleGivesWayAtThePublishedForceAndDent) {
    constexpr double least = 0.5, most = 2.0;                  // [N] of livers' capsules under needles of 18G to 20G
    constexpr double half_space = 0.01, with_a_mesh = 0.05;    // of the dent: the modulus is fitted to the first
    for (const std::string tissue : {"half_space", "mesh"}) {
        const Trace trace = play(scene, tissue == "mesh" ? meshed("[10, 10, 5]") : Overrides{});
        print_events(trace);
        const Happening* const punctured = trace.first("punctured");
        ASSERT_NE(punctured, nullptr);
        const double force = trace.samples[punctured->tick - 1].hand_force, dent = trace.samples[punctured->tick - 1].depth;
        measured(tissue + "_force", force, "N");
        measured(tissue + "_dent", dent, "m");
        measured(tissue + "_dent_over_measured", dent / measured_dent(force));
        EXPECT_GE(force, least);
        EXPECT_LE(force, most);
        EXPECT_NEAR(dent / measured_dent(force), 1.0, tissue == "mesh" ? with_a_mesh : half_space);
        expect_sound(trace);
    }
}

// What a tissue without a curve of its own can't do: see the scene.
TEST(BovineLiver, PushesBackHarderThanTheCapsuleUntilThen) {
    constexpr double half_way = 0.0115;    // [m] of dent
    constexpr double linear = 0.625, curved = 0.327, near = 0.01;
    const Trace trace = play(scene);
    for (const core::Sample& sample : trace.samples) {
        if (sample.depth < half_way) continue;
        measured("hand_force_half_way", sample.hand_force, "N");
        measured("measured_curve_half_way", 2.0 * sample.depth + 2300.0 * sample.depth * sample.depth, "N");
        EXPECT_NEAR(sample.hand_force, linear, near);
        EXPECT_NEAR(2.0 * sample.depth + 2300.0 * sample.depth * sample.depth, curved, near);
        return;
    }
    FAIL() << "the tip never came so deep";
}

TEST(BovineLiver, IsCutAtTheForceOfItsToughnessAThirdBelowOkamuras) {
    constexpr double cutting = 2.0 * std::numbers::pi * 0.635e-3 * 164.0;    // [N] 2π r J, Gokgol's J
    constexpr double okamura = 0.94;                                         // [N]
    constexpr double solved = 1e-6, between_experiments = 0.35;
    const Trace trace = play(scene);
    const Insertion inside = insertion_of(trace);
    double force = 0.0;
    for (std::size_t tick = inside.first; tick <= inside.end; ++tick) force = std::max(force, trace.samples[tick].tip_force);
    measured("cutting_force", force, "N");
    measured("over_okamura", force / okamura);
    EXPECT_NEAR(force, cutting, solved);
    EXPECT_NEAR(force / okamura, 1.0, between_experiments);
}

TEST(BovineLiver, GripsTheShaftAsMeasured) {
    constexpr double slipping = 10.6, sticking = 18.5;    // [N/m] Okamura
    constexpr double entering = 0.05;                     // of the rise: the piece of shaft that is just entering its contact
    const Trace trace = play(scene);
    const Insertion inside = insertion_of(trace);
    const core::Sample &middle = trace.samples[(inside.first + inside.end) / 2], &end = trace.samples[inside.end];
    const double rise = (end.friction_force - middle.friction_force) / (end.inserted - middle.inserted);
    measured("rise_per_length", rise, "N/m");
    EXPECT_NEAR(rise, slipping, entering * slipping);
    double strongest = 0.0, strongest_out = 0.0;    // [N/m]
    for (const core::Sample& sample : trace.samples) {
        if (sample.inserted < 0.01) continue;    // [m] too short to divide by
        const double grip = sample.friction_force / sample.inserted;
        strongest = std::max(strongest, grip);
        strongest_out = std::max(strongest_out, -grip);
    }
    measured("strongest_on_the_way_in", strongest, "N/m");
    measured("strongest_on_the_way_out", strongest_out, "N/m");
    EXPECT_LE(strongest, sticking);
    EXPECT_LE(strongest_out, sticking);
    EXPECT_GT(strongest_out, slipping) << "it never stuck";
}

TEST(BovineLiver, LetsTheNeedleGoWithoutAForceLeft) {
    constexpr double nothing = 1e-6;    // [N]
    const Trace trace = play(scene);
    print_events(trace);
    measured("books", trace.relative);
    EXPECT_LT(trace.samples[trace.samples.size() - 4000].hand_force, 0.0) << "the shaft isn't held back";
    EXPECT_NEAR(trace.samples.back().hand_force, 0.0, nothing);
    EXPECT_EQ(trace.samples.back().inserted, 0.0);
}

TEST(BovineLiver, FeelsTheSameToEveryNeedleOf18G) {
    constexpr double alike = 0.01;    // of the peak: steel so thick neither bends nor buckles here
    const Trace rigid = play(scene);
    for (const std::string type : {"beam_column", "elastica", "rod"}) {
        const Trace trace = play(scene, with_needle(type));
        ASSERT_EQ(trace.samples.size(), rigid.samples.size());
        EXPECT_EQ(trace.count("buckled"), 0u);
        double sum = 0.0;
        for (std::size_t i = 0; i < trace.samples.size(); ++i) {
            sum += std::pow(trace.samples[i].hand_force - rigid.samples[i].hand_force, 2);
        }
        const double rms = std::sqrt(sum / static_cast<double>(trace.samples.size())) / rigid.peak_hand_force();
        measured(type + "_against_rigid", rms);
        EXPECT_LE(rms, alike) << type;
        expect_sound(trace);
    }
}

}    // namespace
}    // namespace stylet::whole_scenes
