// What the fast solver tells of contacts, against the plain one (solid/newton.h) and against where they then are.
#include "fast/quasi_newton.h"
#include "fast/rest_for_tests.h"
#include "fast/solvers_for_tests.h"
#include "solid/newton.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>
#include <vector>

namespace stylet::corotational_fem {
namespace {

using namespace testing;

// What core does: forces such that two footprints are where the needle wants them.
VectorX hold(Solver& solver, const VectorX& where, VectorX forces, int most) {
    const Eigen::Index rows = where.size();
    VectorX free(rows);
    MatrixX compliance(rows + 8, rows);
    for (int i = 0; i < most; ++i) {
        solver.linearise(static_cast<int>(rows) / 3, free, compliance.topRows(rows));
        forces = compliance.topRows(rows).ldlt().solve(where - free);
        solve(solver, Forces(forces.data(), rows));
    }
    return forces;
}

TEST(QuasiNewtonContacts, AreAnsweredAsNewtonDoes) {
    constexpr double close = 5e-3;    // of the force: the accuracy of displacements that are half gravity's
    const Block block;
    for (const bool implicit : {true, false}) {
        Motion motion = falling(2e-3);
        motion.implicit = implicit;
        QuasiNewton fast(block.mesh, block.materials, motion, 1e-4, one_thread());
        Newton plain(block.mesh, block.materials, motion);
        VectorX fast_forces = VectorX::Zero(6), plain_forces = VectorX::Zero(6);
        for (int i = 0; i < 20; ++i) {
            VectorX where(6);
            where << 0.0, 1e-4 * i, -4e-4 * i, -1e-4 * i, 0.0, -2e-4 * i;
            for (Solver* each : {static_cast<Solver*>(&fast), static_cast<Solver*>(&plain)}) {
                each->place(0, block.footprint(0));
                each->place(1, block.footprint(1));
                each->predict(motion.dt);
            }
            fast_forces = hold(fast, where, fast_forces, 2);
            plain_forces = hold(plain, where, plain_forces, 6);
            fast.commit();
            plain.commit();
            EXPECT_LT((fast_forces - plain_forces).norm(), close * plain_forces.norm() + 1e-5) << i;
        }
        std::printf("  held with %.3f N, %.3f by Newton\n", fast_forces.norm(), plain_forces.norm());
    }
}

TEST(QuasiNewtonContacts, MoveAsTheComplianceSays) {
    constexpr double close = 2e-3;    // of half-precision blocks
    const Block block;
    Motion motion = falling(1e-3);
    motion.gravity.setZero();
    QuasiNewton fast(block.mesh, block.materials, motion, 1e-5, one_thread());
    constexpr int contacts = 3, rows = 3 * contacts;
    for (int i = 0; i < contacts; ++i) fast.place(i, block.footprint(i));
    fast.predict(motion.dt);
    VectorX free(rows);
    MatrixX compliance(rows, rows);
    fast.linearise(contacts, free, compliance);
    EXPECT_EQ(free.norm(), 0.0);
    EXPECT_EQ(compliance, compliance.transpose());
    EXPECT_GT(compliance.ldlt().vectorD().minCoeff(), 0.0);
    for (int k = 0; k < rows; ++k) {
        const VectorX forces = 1e-4 * VectorX::Unit(rows, k);    // [N] so small that nothing turns
        solve(fast, Forces(forces.data(), rows));
        for (int i = 0; i < contacts; ++i) {
            Vector3 moved = Vector3::Zero();
            for (const auto& [node, weight] : block.footprint(i)) moved += weight * fast.displacement(node);
            EXPECT_LT((moved - 1e-4 * compliance.block<3, 1>(3 * i, k)).norm(), close * 1e-4 * compliance.col(k).norm());
        }
    }
}

/// A contact that moves on through the middle of a block, as core takes its steps: under the old force, then under another one.
class Passage {
public:
    explicit Passage(bool implicit) : motion_(falling(1e-3)) { motion_.implicit = implicit; }

    [[nodiscard]] const Motion& motion() const { return motion_; }
    [[nodiscard]] const Block& block() const { return block_; }

    void begin(Solver& solver, double gone, const VectorX& force) const {
        solver.place(0, footprint(gone));
        solver.predict(0.0);
        solve(solver, Forces(force.data(), 3));
    }

    [[nodiscard]] Vector3 mean(const Solver& solver, double gone) const {
        Vector3 mean = Vector3::Zero();
        for (const auto& [node, weight] : footprint(gone)) mean += weight * solver.displacement(node);
        return mean;
    }

private:
    [[nodiscard]] std::vector<NodeWeight> footprint(double gone) const {
        std::vector<NodeWeight> footprint = block_.footprint(0);
        footprint[0].weight -= 0.2 * gone;
        footprint[1].weight += 0.2 * gone;
        return footprint;
    }

    Block block_;
    Motion motion_;
};

TEST(QuasiNewtonContacts, GoOnFromRestWhereTheComplianceSays) {
    constexpr double aim = 1e-3;    // of displacements: what a step leaves is made up for as the contact moves on again
    constexpr int ticks = 20;
    const Passage passage(false);
    const Block& block = passage.block();
    const double dt = passage.motion().dt;
    QuasiNewton fast(block.mesh, block.materials, passage.motion(), aim, one_thread());
    Newton plain(block.mesh, block.materials, passage.motion());
    VectorX force = Vector3(0.0, 0.0, -0.2), free(3);
    MatrixX compliance(3, 3);
    double worst = 0.0;
    for (int i = 0; i < ticks; ++i) {
        const double gone = static_cast<double>(i) / ticks;
        passage.begin(fast, gone, force);
        passage.begin(plain, gone, force);
        fast.predict(dt);
        plain.predict(dt);
        force = Vector3(0.01 * gone, 0.0, -0.2 - 0.04 * gone);    // [N] in steps of a hundredth: one iteration each
        const long long before = fast.iterations();
        fast.linearise(1, free, compliance);
        EXPECT_EQ(fast.try_step(Forces(force.data(), 3)).residual, 0.0) << i;
        EXPECT_LE(fast.iterations(), before + 1) << i;
        const Vector3 mean = passage.mean(fast, gone);
        EXPECT_LT((free + compliance * force - mean).norm(), 1e-6 * mean.norm()) << i;
        solve(plain, Forces(force.data(), 3));
        fast.commit();
        plain.commit();
        worst = std::max(worst, difference(block.mesh, fast, plain));
    }
    std::printf("  at worst %.1e of Newton's displacements off, aimed at %.0e\n", worst, aim);
    EXPECT_LT(worst, aim);
}

// Steps of any size, loads that change between the two halves of a tick, ticks taken back.
TEST(QuasiNewtonContacts, AreWhereTheyWereToldHoweverTheSolverIsCalled) {
    constexpr double aim = 3e-2;    // coarse: what may be left undone shows
    constexpr int ticks = 200;
    for (const bool implicit : {false, true}) {
        const Passage passage(implicit);
        const Block& block = passage.block();
        QuasiNewton fast(block.mesh, block.materials, passage.motion(), aim, one_thread());
        Newton plain(block.mesh, block.materials, passage.motion());
        std::mt19937 random(1);
        const auto uniform = [&](double from, double to) { return std::uniform_real_distribution(from, to)(random); };
        VectorX force = Vector3(0.0, 0.0, -0.2), free(3);
        MatrixX compliance(3, 3);
        double worst = 0.0, worst_beside = 0.0;
        for (int i = 0; i < ticks; ++i) {
            const double gone = uniform(0.0, 1.0), pushed = uniform(0.0, 0.5);
            const bool loaded = uniform(0.0, 1.0) < 0.2, taken_back = uniform(0.0, 1.0) < 0.2;
            const double step = std::pow(10.0, uniform(-9.0, -1.0));    // [N]
            const VectorX next = force + step * Vector3(uniform(-1.0, 1.0), uniform(-1.0, 1.0), uniform(-1.0, 1.0));
            for (Solver* each : {static_cast<Solver*>(&fast), static_cast<Solver*>(&plain)}) {
                passage.begin(*each, gone, force);
                if (loaded) each->load(block.push(pushed));
                each->predict(passage.motion().dt);
            }
            fast.linearise(1, free, compliance);
            const VectorX there = free + compliance * next;
            if (fast.try_step(Forces(next.data(), 3)).residual == 0.0) {
                const double beside = (passage.mean(fast, gone) - there).norm() - 1e-8 - 1e-6 * there.norm();
                worst_beside = std::max(worst_beside, beside);
            }
            solve(fast, Forces(next.data(), 3));
            solve(plain, Forces(next.data(), 3));
            worst = std::max(worst, difference(block.mesh, fast, plain));
            if (taken_back) {
                fast.rollback();
                plain.rollback();
            } else {
                force = next;
                fast.commit();
                plain.commit();
            }
        }
        std::printf("  %s: at worst %.1e of Newton's displacements off, aimed at %.0e; %.1e m beside what it told\n",
                    implicit ? "swinging" : "quasi-static", worst, aim, std::max(0.0, worst_beside));
        EXPECT_LT(worst, aim);
        EXPECT_LE(worst_beside, 0.0) << "in balance, though not where it said, by more than single precision knows";
    }
}

// A mesh large enough for contacts to be worth two threads.
TEST(QuasiNewtonContacts, AreAnsweredInTheSameBitsOnTwoThreads) {
    constexpr double accuracy = 1e-3;
    constexpr int contacts = 3, rows = 3 * contacts;
    const Mesh mesh = block_mesh(gel(), {14, 12, 10});
    const std::vector<Material> materials{gel_of(0.49)};
    Threads two(2);
    Motion motion = falling(1e-3);
    motion.implicit = false;
    QuasiNewton alone(mesh, materials, motion, accuracy, one_thread()), together(mesh, materials, motion, accuracy, two);
    VectorX free(rows), free_together(rows), forces(rows);
    MatrixX compliance(rows, rows), compliance_together(rows, rows);
    for (int i = 0; i < 5; ++i) {
        for (QuasiNewton* each : {&alone, &together}) {
            for (int c = 0; c < contacts; ++c) {
                const int node = mesh.node_count() - 100 - 300 * c;
                each->place(c, std::vector<NodeWeight>{{node, 0.5 + 0.1 * i}, {node - 1, 0.5 - 0.1 * i}});
            }
            each->predict(motion.dt);
        }
        alone.linearise(contacts, free, compliance);
        together.linearise(contacts, free_together, compliance_together);
        ASSERT_EQ(compliance, compliance_together) << i;
        ASSERT_EQ(free, free_together) << i;
        for (int k = 0; k < rows; ++k) forces[k] = 0.01 * (k + 1) * (i + 1);
        for (QuasiNewton* each : {&alone, &together}) {
            solve(*each, Forces(forces.data(), rows));
            each->commit();
        }
    }
    for (int node = 0; node < mesh.node_count(); ++node) ASSERT_EQ(alone.displacement(node), together.displacement(node));
}

}    // namespace
}    // namespace stylet::corotational_fem
