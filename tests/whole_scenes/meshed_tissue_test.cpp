// The paper's insertions into a tissue of finite elements, by changing the tissue's section alone.
#include "core/workers/worker_pool.h"
#include "tests/whole_scenes/trace.h"

#include <gtest/gtest.h>

#include <malloc.h>
#include <cmath>

namespace stylet::whole_scenes {
namespace {

const core::Override meshed{"tissue.type", "corotational_fem"};

core::Override own(const std::string& key, const std::string& value) {
    return {"tissue.corotational_fem." + key, value};
}

double hand_force_at(const Trace& trace, double travel) {
    for (const core::Sample& sample : trace.samples) {
        if (sample.travel >= travel) return sample.hand_force;
    }
    return trace.samples.back().hand_force;
}

TEST(MeshedTissue, PushesBackAlikeWhateverItsMesh) {
    constexpr double alike = 0.05;                                                                            // the bound
    const double travels[] = {0.005, 0.01, 0.02, 0.03, 0.04, 0.05, 0.055, 0.06, 0.065, 0.07, 0.075, 0.08};    // [m]
    std::vector<Trace> traces;
    for (const char* cells : {"[6, 6, 3]", "[10, 10, 4]", "[16, 16, 6]"}) {
        traces.push_back(play(paper_scene("fig10a_l150"), {meshed, own("cells", cells)}));
        const Happening* punctured = traces.back().first("punctured");
        ASSERT_NE(punctured, nullptr) << cells;
        measured(std::string("punctured_at_") + cells, punctured->depth, "m");
        measured(std::string("books_of_") + cells, traces.back().relative);
        expect_sound(traces.back());
    }
    double worst = 0.0;
    for (const double travel : travels) {
        const double finest = hand_force_at(traces.back(), travel);
        for (const Trace& trace : traces) worst = std::max(worst, std::abs(hand_force_at(trace, travel) / finest - 1.0));
    }
    measured("worst_difference", worst);
    EXPECT_LE(worst, alike);
}

TEST(MeshedTissue, FeelsLikeTheHalfSpaceWhereItsBlockIsWide) {
    constexpr double wide = 0.02;    // of the force: the block is 400 mm wide and 150 mm deep, which stiffens it by 1/100
    const Trace half_space = play(paper_scene("fig10a_l150"));
    const Trace mesh = play(paper_scene("fig10a_l150"), {meshed, own("cells", "[10, 10, 4]")});
    for (const double travel : {0.01, 0.03, 0.05, 0.06, 0.08}) {
        const double ratio = hand_force_at(mesh, travel) / hand_force_at(half_space, travel);
        measured("over_half_space_at_" + std::to_string(static_cast<int>(1e3 * travel)) + "_mm", ratio);
        EXPECT_NEAR(ratio, 1.0, wide);
    }
}

TEST(MeshedTissue, BucklesTheLongNeedleAsTheHalfSpaceDoes) {
    constexpr double alike = 0.02;    // of the force
    const Trace half_space = play(paper_scene("fig10a_l200"));
    const Trace mesh = play(paper_scene("fig10a_l200"), {meshed, own("cells", "[10, 10, 4]")});
    ASSERT_NE(mesh.first("buckled"), nullptr);
    EXPECT_EQ(mesh.first("punctured"), nullptr);
    measured("buckled_at", mesh.first("buckled")->hand_force, "N");
    EXPECT_NEAR(mesh.first("buckled")->hand_force / half_space.first("buckled")->hand_force, 1.0, alike);
    expect_sound(mesh);
}

TEST(MeshedTissue, TakesARodThroughTwoLayers) {
    const Trace trace =
        play(paper_scene("fig9"),
             {meshed, own("cells", "[10, 10, 5]"), {"needle.type", "rod"}, {"effects[0].rupture_force", "0.5 N"}});
    print_events(trace);
    EXPECT_NE(trace.first("punctured"), nullptr);
    EXPECT_NE(trace.first("crossed an interface"), nullptr);
    expect_sound(trace);
}

TEST(MeshedTissue, IsTheSameInSinglePrecisionAndInDouble) {
    constexpr double accuracy = 2e-3;    // of the force: twice what the scene asks of the displacements
    const Trace single = play(paper_scene("fig10a_l150"), {meshed, own("cells", "[6, 6, 3]")}, {}, std::size_t{5500});
    const Trace exact =
        play(paper_scene("fig10a_l150"), {meshed, own("cells", "[6, 6, 3]"), own("solver", "newton")}, {}, std::size_t{5500});
    double worst = 0.0;
    for (std::size_t i = 0; i < exact.samples.size(); ++i) {
        if (exact.near_event(i, 20) || single.near_event(i, 20)) continue;
        worst = std::max(worst, std::abs(single.samples[i].hand_force - exact.samples[i].hand_force));
    }
    measured("single_against_double", worst, "N");
    measured("books_in_double", exact.relative);
    // The rupture itself, whose ticks the comparison of forces leaves out, by what it leaves behind.
    const core::Sample &one = single.samples.back(), &other = exact.samples.back();
    measured("burst_in_single", one.burst, "J");
    measured("burst_in_double", other.burst, "J");
    EXPECT_NEAR(one.burst, other.burst, accuracy * other.burst);
    EXPECT_NEAR(one.friction + one.released, other.friction + other.released, accuracy * other.friction);
    EXPECT_LE(worst, accuracy * exact.peak_hand_force());
}

TEST(MeshedTissue, CreepsWithoutLosingEnergyFromTheBooks) {
    const Trace trace = play(paper_scene("fig10a_l150"), {meshed, own("cells", "[6, 6, 3]"), own("damping_time", "100 ms")});
    measured("damping", trace.samples.back().damping, "J");
    measured("books", trace.relative);
    EXPECT_GT(trace.samples.back().damping, 0.0);
    expect_sound(trace);
}

// A hand that hardly moves: what a tick changes is less than what the solver's accuracy leaves.
TEST(MeshedTissue, KeepsItsBooksWhereANeedleHardlyMoves) {
    constexpr std::size_t slow = 1000;    // ticks of the second stretch
    // Of that stretch's own work: ten times the square of the accuracy, for energy is of second order in what that leaves.
    constexpr double share = 1e-5;
    const core::Override hand{"device.motion", "[{insert: 40 mm, speed: 50 mm/s}, {insert: 0.1 mm, speed: 0.1 mm/s}]"};
    Stage stage(paper_scene("fig10a_l150"), {meshed, own("cells", "[6, 6, 3]"), {"effects[0].rupture_force", "0.4 N"}, hand});
    const Trace trace = play(stage);
    const core::Sample& last = trace.samples.back();
    const core::Sample& first = trace.samples[trace.samples.size() - slow];
    const double work = last.hand_work - first.hand_work, lost = last.residual - first.residual;
    measured("work", work, "J");
    measured("lost", lost, "J");
    EXPECT_GT(work, 0.0);
    EXPECT_LE(std::abs(lost), share * work);
}

TEST(MeshedTissue, ReadsAMeshWithAHardBallInIt) {
    const Trace trace = play(std::filesystem::path(SCENE_FOLDER) / "meshed/stiff_ball.yaml");
    print_events(trace);
    EXPECT_EQ(trace.count("crossed an interface"), 2u) << "into the ball and out of it";
    expect_sound(trace);
}

// Hard case 10. The tip is a rigid punch on a half-space: F = 2aE*δ, and the needle as good as rigid beside the tissue.
TEST(MeshedTissue, DentsUnderSteelAsHertzSaysWhereItIsSoft) {
    constexpr double exact = 0.01;
    constexpr double radius = 0.3e-3, modulus = 1e3 / (1.0 - 0.49 * 0.49), depth = 2e-3;    // [m], [Pa], [m]
    const Trace trace = play(
        paper_scene("fig10a_l150"),
        {meshed, own("cells", "[12, 12, 6]"), {"tissue.layers[0].youngs_modulus", "1 kPa"}, {"device.motion[0].insert", "4 mm"}});
    const double stiffness = trace.samples.back().hand_force / depth / (2.0 * radius * modulus);
    measured("stiffness_over_punch", stiffness);
    EXPECT_NEAR(stiffness, 1.0, exact);
    expect_sound(trace, 1e-6);
}

/// The tissue of a block alone, so many steps; where its patch is at the end.
Vector3 patch_after(std::size_t ticks, Workers& workers, const core::PluginFolders& folders) {
    const core::Scene scene = core::read_scene(validation_scene("block_m0"), {}, folders);
    const core::Cast cast(scene, folders, workers);
    core::Simulation simulation(scene, cast);
    const auto allocated = [] {
        const auto info = mallinfo2();
        return info.uordblks + info.hblkhd;
    };
    simulation.tick();
    const std::size_t before = allocated();
    for (std::size_t i = 1; i < ticks; ++i) simulation.tick();
    EXPECT_EQ(allocated(), before) << "memory grew";
    return simulation.loads().displacement(0);
}

// Hard case 38, shortened; a million ticks take the same code.
TEST(MeshedTissue, GivesTheSameBitsForOneThreadAndTwo) {
    constexpr std::size_t ticks = 5000;
    core::WorkerPool pool(2, std::nullopt);
    const Vector3 alone = patch_after(ticks, one_thread(), plugin_folders());
    EXPECT_EQ(alone, patch_after(ticks, pool, plugin_folders()));
    measured("settled", alone.z(), "m");
}

}    // namespace
}    // namespace stylet::whole_scenes
