// The fast solver against the plain one (solid/newton.h): the same motion, the same energies, the same answers to contacts.
#include "fast/quasi_newton.h"

#include "fast/rest_for_tests.h"
#include "fast/solvers_for_tests.h"
#include "solid/newton.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <vector>

namespace stylet::corotational_fem {
namespace {

using namespace testing;

constexpr double accuracy = 1e-3;
// Of the displacements' norm, over a whole run: what the issue of this solver allows.
constexpr double allowed = 2e-3, allowed_where_it_turns = 5e-3;

double total(const EnergyReport& energy) {
    return energy.stored + energy.kinetic + energy.damping + energy.numerical;
}

struct Outcome {
    double worst = 0.0;           // [1] of the displacements
    double worst_energy = 0.0;    // [1] of the greatest energy
};

Outcome follow(const Block& block, const Motion& motion, double dt, double force, int steps) {
    QuasiNewton fast(block.mesh, block.materials, motion, accuracy, one_thread());
    Newton plain(block.mesh, block.materials, motion);
    Outcome outcome;
    double greatest = 0.0, apart = 0.0;
    for (Solver* each : {static_cast<Solver*>(&fast), static_cast<Solver*>(&plain)}) each->load(block.push(force));
    for (int i = 0; i < steps; ++i) {
        step(fast, dt);
        step(plain, dt);
        outcome.worst = std::max(outcome.worst, difference(block.mesh, fast, plain));
        const EnergyReport a = fast.energy(), b = plain.energy();
        for (const auto part :
             {&EnergyReport::stored, &EnergyReport::kinetic, &EnergyReport::damping, &EnergyReport::numerical}) {
            apart = std::max(apart, std::abs(a.*part - b.*part));
            greatest = std::max(greatest, std::abs(b.*part));
        }
    }
    outcome.worst_energy = apart / greatest;
    std::printf("  dt %g ms, %g N: displacements within %.3f %%, energies %.3f %%, %.2f iterations a step\n", 1e3 * dt, force,
                100.0 * outcome.worst, 100.0 * outcome.worst_energy, static_cast<double>(fast.iterations()) / steps);
    return outcome;
}

TEST(QuasiNewton, FollowsNewtonWhenWeightAndLoadAreSwitchedOn) {
    for (const double poisson_ratio : {0.45, 0.49}) {
        for (const double dt : {1e-3, 1e-2}) {
            Block block;
            block.materials = {gel_of(poisson_ratio)};
            const Outcome outcome = follow(block, falling(dt), dt, 1.0, 60);
            EXPECT_LT(outcome.worst, allowed);
            EXPECT_LT(outcome.worst_energy, 2.0 * allowed);
        }
    }
}

TEST(QuasiNewton, FollowsNewtonAtFourTimesTheLoad) {
    for (const double dt : {1e-3, 1e-2}) EXPECT_LT(follow(Block(), falling(dt), dt, 4.0, 60).worst, allowed_where_it_turns);
}

TEST(QuasiNewton, FollowsNewtonWithDampingAndSharedPressure) {
    for (const bool shared : {false, true}) {
        for (const double damping : {0.0, 2e-3}) {
            Motion motion = falling(2e-3);
            motion.damping_time = damping;
            motion.share_pressure = shared;
            const Outcome outcome = follow(Block(), motion, motion.dt, 1.0, 40);
            EXPECT_LT(outcome.worst, allowed);
            EXPECT_LT(outcome.worst_energy, 2.0 * allowed);
        }
    }
}

TEST(QuasiNewton, FollowsNewtonInStepsOfAnotherLength) {
    for (const double ratio : {0.5, 0.25, 4.0, 10.0}) {
        EXPECT_LT(follow(Block(), falling(1e-3), ratio * 1e-3, 1.0, 30).worst, allowed_where_it_turns) << ratio;
    }
}

TEST(QuasiNewton, FindsTheRestOfATissueWithoutInertia) {
    const Block block;
    for (const bool heavy : {false, true}) {
        const Motion motion{.implicit = false, .gravity = Vector3(0, 0, heavy ? -9.81 : 0.0), .dt = 1e-3};
        QuasiNewton fast(block.mesh, block.materials, motion, accuracy, one_thread());
        Newton plain(block.mesh, block.materials, motion);
        for (const double force : {0.5, 1.0, 4.0, 2.0, 1.0}) {
            for (Solver* each : {static_cast<Solver*>(&fast), static_cast<Solver*>(&plain)}) {
                each->load(block.push(force));
                step(*each, motion.dt);
            }
            EXPECT_LT(difference(block.mesh, fast, plain), force > 1.0 ? allowed_where_it_turns : allowed) << force;
            EXPECT_NEAR(fast.energy().stored, plain.energy().stored, 2.0 * allowed * std::abs(plain.energy().stored));
            EXPECT_EQ(fast.energy().kinetic, 0.0);
        }
    }
}

TEST(QuasiNewton, FindsTheRestOfLayersOfVeryDifferentStiffness) {
    Block block;
    for (int e = 0; e < block.mesh.size(); ++e) {
        double height = 0.0;
        for (const int node : block.mesh.tetrahedra[e]) height += 0.25 * block.mesh.nodes[node].z();
        block.mesh.layers[e] = height > -0.025 ? 0 : 1;
    }
    for (const double contrast : {1e-3, 1e3, 1e6}) {
        for (const double poisson_ratio : {0.3, 0.499}) {
            block.materials = {gel_of(poisson_ratio), gel_of(poisson_ratio)};
            block.materials[1].shear_modulus *= contrast;
            block.materials[1].lame *= contrast;
            for (const bool implicit : {false, true}) {
                Motion motion = falling(1e-2);
                motion.implicit = implicit;
                motion.gravity.setZero();
                QuasiNewton fast(block.mesh, block.materials, motion, accuracy, one_thread());
                Newton plain(block.mesh, block.materials, motion);
                const double force = std::min(1.0, contrast);
                for (Solver* each : {static_cast<Solver*>(&fast), static_cast<Solver*>(&plain)}) {
                    each->load(block.push(force));
                    for (int i = 0; i < 5; ++i) step(*each, motion.dt);
                }
                const double apart = difference(block.mesh, fast, plain);
                std::printf("  contrast %g, Poisson's ratio %g, %s: within %.4f %%, %lld iterations\n", contrast, poisson_ratio,
                            implicit ? "implicit" : "quasi-static", 100.0 * apart, fast.iterations());
                EXPECT_LT(apart, allowed_where_it_turns);
            }
        }
    }
}

TEST(QuasiNewton, ReturnsToRestFromALoadThatTurnsTetrahedraInsideOut) {
    constexpr double at_rest = 1e-3;    // of the block's depth
    constexpr double depth = 0.05;      // [m]
    const Block block;
    for (const double dt : {5e-3, 1e-2}) {
        Motion motion = falling(dt);
        motion.gravity.setZero();
        motion.damping_time = 0.05;
        QuasiNewton fast(block.mesh, block.materials, motion, accuracy, one_thread());
        fast.load(block.push(60.0));
        for (double now = 0.0; now < 0.3; now += dt) {
            step(fast, dt);
            for (int node = 0; node < block.mesh.node_count(); ++node) ASSERT_LT(fast.displacement(node).norm(), 1.0);
        }
        EXPECT_TRUE(fast.inverted());
        fast.load({});
        for (double now = 0.0; now < 1.5; now += dt) step(fast, dt);
        double furthest = 0.0;
        for (int node = 0; node < block.mesh.node_count(); ++node) {
            furthest = std::max(furthest, fast.displacement(node).norm());
        }
        EXPECT_LT(furthest, at_rest * depth);
        EXPECT_FALSE(fast.inverted());
    }
}

TEST(QuasiNewton, MakesNoEnergy) {
    constexpr double noise = 1e-4;    // of the work done
    for (const double dt : {1e-4, 1e-3, 1e-2, 1e-1}) {
        const Block block;
        Motion motion = falling(dt);
        QuasiNewton fast(block.mesh, block.materials, motion, accuracy, one_thread());
        const std::vector<NodeForce> push = block.push(2.0);
        fast.load(push);
        double work = 0.0, last = 0.0, greatest = 0.0;
        for (int i = 0; i < 100; ++i) {
            step(fast, dt);
            double along = 0.0;
            for (const NodeForce& each : push) along += each.force.dot(fast.displacement(each.node));
            work += along - last;    // of a constant force
            last = along;
            greatest = std::max(greatest, std::abs(work));
            const EnergyReport energy = fast.energy();
            // The first step's trapezoid begins without the load.
            EXPECT_LT(energy.stored + energy.kinetic, work + noise * greatest) << dt;
            EXPECT_GT(energy.numerical, -noise * greatest) << dt;
        }
    }
}

TEST(QuasiNewton, DoesNoWorkTwice) {
    const Block block;
    Motion motion = falling(1e-3);
    QuasiNewton fast(block.mesh, block.materials, motion, accuracy, one_thread());
    fast.place(0, block.footprint(0));
    const VectorX forces = Vector3(0.01, 0.0, -0.2);
    const Forces acting(forces.data(), 3);
    for (int i = 0; i < 5; ++i) step(fast, motion.dt, acting);
    const long long iterations = fast.iterations();
    const EnergyReport energy = fast.energy();
    VectorX free(3), again(3);
    MatrixX compliance(3, 3), same(3, 3);
    fast.predict(0.0);
    fast.linearise(1, free, compliance);
    EXPECT_EQ(fast.try_step(acting).residual, 0.0);
    const VectorX nearly = forces + Vector3(0.0, 0.0, 1e-10);
    EXPECT_EQ(fast.try_step(Forces(nearly.data(), 3)).residual, 0.0);
    EXPECT_EQ(fast.try_step(acting).residual, 0.0);
    fast.linearise(1, again, same);
    EXPECT_EQ(fast.iterations(), iterations);
    EXPECT_EQ(total(fast.energy()), total(energy));
    EXPECT_EQ(free, again);
    EXPECT_EQ(compliance, same);
    // And is where it is.
    Vector3 mean = Vector3::Zero();
    for (const auto& [node, weight] : block.footprint(0)) mean += weight * fast.displacement(node);
    EXPECT_LT((free + compliance * forces - mean).norm(), 1e-6 * mean.norm());
}

TEST(QuasiNewton, TakesTheLastStepAgainWithOtherForces) {
    const Block block;
    const Motion motion = falling(1e-3);
    QuasiNewton once(block.mesh, block.materials, motion, 1e-5, one_thread());
    QuasiNewton twice(block.mesh, block.materials, motion, 1e-5, one_thread());
    const VectorX some = Vector3(0.0, 0.0, -0.2), more = Vector3(0.05, 0.0, -0.4);
    for (QuasiNewton* each : {&once, &twice}) each->place(0, block.footprint(0));
    for (int i = 0; i < 10; ++i) {
        step(once, motion.dt, Forces(more.data(), 3));
        twice.predict(motion.dt);
        solve(twice, Forces(some.data(), 3));
        twice.commit();
        twice.predict(0.0);
        solve(twice, Forces(more.data(), 3));
        twice.commit();
    }
    EXPECT_LT(difference(block.mesh, twice, once), 1e-4);    // ten steps at 1e-5
}

TEST(QuasiNewton, GoesBackBitForBitAndThenTheSameWayAgain) {
    const Block block;
    for (const double damping : {0.0, 1e-3}) {
        Motion motion = falling(1e-3);
        motion.damping_time = damping;
        QuasiNewton straight(block.mesh, block.materials, motion, accuracy, one_thread());
        QuasiNewton back(block.mesh, block.materials, motion, accuracy, one_thread());
        const VectorX some = Vector3(0.0, 0.0, -0.2), more = Vector3(0.05, 0.0, -4.0);
        for (QuasiNewton* each : {&straight, &back}) {
            each->place(0, block.footprint(0));
            each->load(block.push(0.5));
        }
        for (int i = 0; i < 12; ++i) {
            const EnergyReport before = back.energy();
            back.predict(i % 3 == 0 ? 0.5 * motion.dt : motion.dt);
            solve(back, Forces(more.data(), 3));
            back.rollback();
            EXPECT_EQ(total(back.energy()), total(before));
            EXPECT_EQ(back.energy().stored, before.stored);
            for (QuasiNewton* each : {&straight, &back}) step(*each, motion.dt, Forces(some.data(), 3));
            for (int node = 0; node < block.mesh.node_count(); ++node) {
                ASSERT_EQ(straight.displacement(node), back.displacement(node)) << i;
            }
            EXPECT_EQ(total(straight.energy()), total(back.energy()));
        }
    }
}

TEST(QuasiNewton, MovesTheSameBitsOnTwoThreads) {
    const Block block;
    Threads two(2);
    for (const InstructionSet set : {InstructionSet::sse2, InstructionSet::avx2, InstructionSet::avx512}) {
        if (!supported(set)) continue;
        Motion motion = falling(1e-3);
        motion.share_pressure = true;
        QuasiNewton alone(block.mesh, block.materials, motion, accuracy, one_thread(), set);
        QuasiNewton together(block.mesh, block.materials, motion, accuracy, two, set);
        for (QuasiNewton* each : {&alone, &together}) {
            each->load(block.push(2.0));
            for (int i = 0; i < 10; ++i) step(*each, motion.dt);
        }
        for (int node = 0; node < block.mesh.node_count(); ++node) {
            ASSERT_EQ(alone.displacement(node), together.displacement(node)) << name(set);
        }
    }
}

TEST(QuasiNewton, FollowsNewtonOnEveryProcessor) {
    const Block block;
    const Motion motion = falling(1e-3);
    Newton plain(block.mesh, block.materials, motion);
    plain.load(block.push(1.0));
    for (int i = 0; i < 20; ++i) step(plain, motion.dt);
    for (const InstructionSet set : {InstructionSet::sse2, InstructionSet::avx2, InstructionSet::avx512}) {
        if (!supported(set)) continue;
        QuasiNewton fast(block.mesh, block.materials, motion, accuracy, one_thread(), set);
        fast.load(block.push(1.0));
        for (int i = 0; i < 20; ++i) step(fast, motion.dt);
        EXPECT_LT(difference(block.mesh, fast, plain), allowed) << name(set);
    }
}

TEST(QuasiNewton, RefusesATissueWithoutDensityThatHasWeight) {
    Block block;
    block.materials[0].density = std::numeric_limits<double>::quiet_NaN();
    const Motion motion = falling(1e-3);
    EXPECT_NE(refusal([&] { QuasiNewton(block.mesh, block.materials, motion, accuracy, one_thread()); }).find("density"),
              std::string::npos);
}

}    // namespace
}    // namespace stylet::corotational_fem
