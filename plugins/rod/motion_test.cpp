// The needle itself, moved through what has no rest on the way: an arch that snaps through, a column far above its critical load.
#include "held_needle.h"
#include "known_rods.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numbers>
#include <tuple>
#include <vector>

namespace stylet::rod {
namespace {

using contract::Case;
using contract::Given;
using std::numbers::pi;

constexpr double length = 0.2, radius = 0.3e-3, steel = 200e9;    // [m], [m], [Pa]
const double bending = steel * pi * std::pow(radius, 4) / 4.0;    // [N·m²]

Case needle(Given parameters, Ends ends, double dt) {
    parameters.set("density", 7850.0);
    parameters.set("poisson_ratio", 0.3);
    return {.parameters = parameters,
            .needle = {.length = length, .radius = radius, .youngs_modulus = steel, .ends = ends},
            .dt = dt};
}

constexpr double unaccounted = 1e-3;    // of the peak work: what may be left of the books

// ---- Hard case 17: an arch between two hinges, pushed at its crown until it snaps through, and let go ----

struct Snap {
    double height_before, height_after;    // [m] of the crown over the line between the hinges, unloaded
    double force;                          // [N] when it moved fastest
    double stored, lost, peak_work;        // [J] at the end; to damping and to the integrator
    double residual;                       // [J]
};

Snap snap_through(double dt) {
    constexpr double rising = 0.6, falling = 0.2, resting = 0.1, most = 0.32;    // [s], [N]
    HeldNeedle arch(
        STYLET_PLUGIN_FILE,
        needle({{"nodes", std::int64_t{21}}, {"imperfection", 2e-5}, {"natural_curvature", 2.0}, {"damping_time", 0.01}},
               Ends::pinned_pinned, dt),
        {0.48 * length, length});
    const Vector3 tip = arch.place(1), down = tip.normalized().cross(Vector3::UnitY());
    arch.held = {false, true, false, true, true, true};    // the crown stays in the arch's plane
    const auto height = [&] { return -arch.place(0).dot(down); };
    Snap snap{};
    snap.height_before = height();
    double fastest = 0.0;    // [m] in a tick
    const auto ticks = static_cast<int>(std::round((rising + falling + resting) / dt));
    for (int tick = 1; tick <= ticks; ++tick) {
        const double time = tick * dt, before = height();
        const double force = most * std::clamp(time < rising ? time / rising : (rising + falling - time) / falling, 0.0, 1.0);
        arch.force.head<3>() = force * down;
        EXPECT_TRUE(arch.tick()) << "at " << time << " s";
        if (before - height() <= fastest) continue;
        fastest = before - height();
        snap.force = force;
    }
    const EnergyReport books = arch.needle->energy();
    snap.height_after = height();
    snap.stored = books.stored;
    snap.lost = books.damping + books.numerical;
    snap.peak_work = arch.peak_work;
    snap.residual = arch.residual();
    return snap;
}

TEST(Arch, SnapsThroughAndAccountsForTheEnergyThatItDrops) {
    double before = std::numeric_limits<double>::infinity();    // [J] left of the books at twice the tick
    for (const double dt : {1e-3, 0.5e-3, 0.25e-3}) {
        const Snap snap = snap_through(dt);
        std::printf(
            "arch, dt %.2f ms: crown from %.2f to %.2f mm, snaps at %.3f N; %.3f mJ stored, %.3f mJ lost, residual %.1e of the "
            "peak work\n",
            1e3 * dt, 1e3 * snap.height_before, 1e3 * snap.height_after, snap.force, 1e3 * snap.stored, 1e3 * snap.lost,
            snap.residual / snap.peak_work);
        EXPECT_LT(snap.height_after, -snap.height_before) << "not on its other branch";
        EXPECT_GT(snap.lost, snap.stored);
        EXPECT_LE(std::abs(snap.residual), unaccounted * snap.peak_work);
        // What trapezoids leave of the damping's work: a quarter at half the tick, and room for it not to be small yet.
        constexpr double second_order = 0.35;
        EXPECT_LE(std::abs(snap.residual), second_order * before);
        before = std::abs(snap.residual);
    }
}

// ---- Columns whose tip is kept on the axis ----

HeldNeedle column(Ends ends, double imperfection, double dt) {
    HeldNeedle held(STYLET_PLUGIN_FILE, needle({{"nodes", std::int64_t{41}}, {"imperfection", imperfection}}, ends, dt),
                    {length});
    held.held = {true, true, false};
    held.at.head<2>().setZero();
    return held;
}

// Hard case 18.
TEST(Column, FarAboveItsCriticalLoadIsFlaggedAndBounded) {
    const double euler = std::pow(pi / length, 2) * bending;    // [N]
    HeldNeedle pushed = column(Ends::pinned_pinned, 2e-5, 1e-3);
    int flagged = 0;
    double farthest = 0.0;    // [m]
    for (int tick = 1; tick <= 400; ++tick) {
        pushed.force[2] = 20.0 * euler * std::min(1.0, tick / 200.0);
        ASSERT_TRUE(pushed.tick()) << "tick " << tick;
        if (flagged == 0 && pushed.needle->beyond_validity() != nullptr) flagged = tick;
        std::vector<Vector3> line(41);
        pushed.needle->centreline(line);
        for (const Vector3& point : line) {
            ASSERT_TRUE(point.allFinite());
            farthest = std::max(farthest, point.norm());
        }
    }
    std::printf(
        "up to 20 times Euler's load: flagged at tick %d, no point over %.4f L from the base, residual %.1e of the peak work\n",
        flagged, farthest / length, pushed.residual() / pushed.peak_work);
    EXPECT_GT(flagged, 0);
    constexpr double stretched = 1e-3;    // a wave of 20 times Euler's load, with room
    EXPECT_LE(farthest, (1.0 + stretched) * length);
    EXPECT_LE(std::abs(pushed.residual()), unaccounted * pushed.peak_work);
}

// [N] of the elastica with this span [m].
double clamped_pinned_load(double span) {
    double straighter = 0.01, bowed = 0.8;    // moduli
    for (int halvings = 0; halvings < 50; ++halvings) {
        const double middle = 0.5 * (straighter + bowed);
        (clamped_pinned(middle).span * length > span ? straighter : bowed) = middle;
    }
    return clamped_pinned(straighter).load * bending / (length * length);
}

constexpr double shortened = 5e-3, duration = 0.5;    // [m], [s]

// Its tip pushed in along the axis; `way` is how much of it is done at each time, both from 0 to 1. Returns the largest force [N]
// after a tenth of the time: at first inertia keeps a needle straight under more than its critical load.
template <class Way>
double push_in(HeldNeedle& pushed, double dt, Way way) {
    pushed.held[2] = true;
    double most = 0.0;
    const auto ticks = static_cast<int>(std::round(duration / dt));
    for (int tick = 1; tick <= ticks; ++tick) {
        const double time = static_cast<double>(tick) / ticks;
        pushed.at[2] = -length + shortened * way(time);
        EXPECT_TRUE(pushed.tick()) << "tick " << tick << " of " << dt << " s";
        if (time > 0.1) most = std::max(most, pushed.force[2]);
    }
    return most;
}

// How long a tick and how small the imperfection.
class ColumnPushed : public testing::TestWithParam<std::tuple<double, double>> {};
INSTANTIATE_TEST_SUITE_P(DtImperfection, ColumnPushed,
                         testing::Combine(testing::Values(0.5e-3, 1e-3, 2e-3, 5e-3), testing::Values(2e-5, 2e-7)));

// Hard case 14. On the straight branch it would bear EA times the strain, 2000 times as much.
TEST_P(ColumnPushed, BearsWhatTheElasticaDoesAndNeverWhatAStraightOneWould) {
    const auto [dt, imperfection] = GetParam();
    const double critical = std::pow(4.493409457909064 / length, 2) * bending, elastica = clamped_pinned_load(length - shortened);
    const auto at_once = [](double time) { return time; };
    const auto gently = [](double time) { return time * time; };
    for (const bool gentle : {true, false}) {
        HeldNeedle pushed = column(Ends::clamped_pinned, imperfection, dt);
        const double most = gentle ? push_in(pushed, dt, gently) : push_in(pushed, dt, at_once);
        std::printf("dt %.1f ms, imperfection %.0e m, %s: at most %.4f of the critical load, %.4f at last; elastica %.4f\n",
                    1e3 * dt, imperfection, gentle ? "gently" : "at once", most / critical, pushed.force[2] / critical,
                    elastica / critical);
        EXPECT_TRUE(pushed.needle->state().buckled);
        constexpr double nodes = 0.003;    // of 41 of them, and of what an imperfection of 1e-4 L adds
        EXPECT_NEAR(pushed.force[2], elastica, nodes * elastica);
        EXPECT_LE(most, 1.14 * critical) << "more than its limit load";
        if (!gentle) continue;    // a blow raises higher modes, and they may throw it to either side
        std::vector<Vector3> line(41);
        pushed.needle->centreline(line);
        EXPECT_GT(line[24].x(), 0.05 * length) << "it bows to its imperfection's side";
    }
}

}    // namespace
}    // namespace stylet::rod
