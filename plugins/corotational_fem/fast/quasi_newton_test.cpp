// The fast solver against the plain one (solid/newton.h): the same motion, the same energies, the same answers to contacts.
#include "fast/quasi_newton.h"

#include "mesh/block_mesh.h"
#include "mesh/meshes_for_tests.h"
#include "solid/newton.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <thread>
#include <vector>

namespace stylet::corotational_fem {
namespace {

constexpr double accuracy = 1e-3;
// Of the displacements' norm, over a whole run: what the issue of this solver allows.
constexpr double allowed = 2e-3, allowed_where_it_turns = 5e-3;

const Forces no_forces(nullptr, 0);

Material gel_of(double poisson_ratio) {
    constexpr double modulus = 25e3;    // [Pa]
    return {.shear_modulus = modulus / (2.0 * (1.0 + poisson_ratio)),
            .lame = modulus * poisson_ratio / ((1.0 + poisson_ratio) * (1.0 - 2.0 * poisson_ratio)),
            .density = 1000.0};
}

Motion falling(double dt) {
    return {.implicit = true, .gravity = Vector3(0, 0, -9.81), .dt = dt};
}

// A block of gel, 100 × 80 × 50 mm, held at the bottom.
struct Block {
    Mesh mesh = block_mesh(gel(), {6, 5, 4});
    std::vector<Material> materials{gel_of(0.49)};

    // The mean of some nodes near the middle of the top, and one by the edge.
    [[nodiscard]] std::vector<NodeWeight> footprint(int which) const {
        const int top = mesh.node_count() - 7 * 6;
        switch (which) {
            case 0:
                return {{top + 3 * 7 + 3, 0.5}, {top + 3 * 7 + 2, 0.3}, {top - 7 * 6 + 3 * 7 + 3, 0.2}};
            case 1:
                return {{top + 2 * 7 + 4, 1.0}};
            default:
                return {{top + 1, 0.6}, {5, 0.4}};    // partly held
        }
    }

    // Spread over the middle of the top.
    [[nodiscard]] std::vector<NodeForce> push(double force) const {
        std::vector<NodeForce> forces;
        for (int i = 0; i < mesh.node_count(); ++i) {
            const Vector3& at = mesh.nodes[i];
            if (at.z() > -1e-9 && at.head<2>().norm() < 0.02) forces.push_back({i, Vector3::Zero()});
        }
        for (NodeForce& each : forces) each.force = Vector3(0.1 * force, 0.0, -force) / static_cast<double>(forces.size());
        return forces;
    }
};

// Until it says that it is in balance.
void solve(Solver& solver, Forces forces = no_forces) {
    constexpr int most = 200;
    VectorX free(forces.size());
    MatrixX compliance(forces.size(), forces.size());
    for (int tries = 0; tries < most; ++tries) {
        solver.linearise(static_cast<int>(forces.size()) / 3, free, compliance);
        if (solver.try_step(forces).residual == 0.0) return;
    }
    FAIL() << "not in balance after " << most << " tries";
}

void step(Solver& solver, double dt, Forces forces = no_forces) {
    solver.predict(dt);
    solve(solver, forces);
    solver.commit();
}

double difference(const Mesh& mesh, const Solver& a, const Solver& b) {
    double apart = 0.0, all = 0.0;
    for (int i = 0; i < mesh.node_count(); ++i) {
        apart += (a.displacement(i) - b.displacement(i)).squaredNorm();
        all += b.displacement(i).squaredNorm();
    }
    return std::sqrt(apart / all);
}

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

TEST(QuasiNewton, AnswersContactsAsNewtonDoes) {
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

TEST(QuasiNewton, MovesFootprintsAsItsComplianceSays) {
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

// As core takes a step: a contact moves on under its old force, and then has another one.
TEST(QuasiNewton, GoesOnFromRestWhereItsComplianceSays) {
    constexpr double aim = 1e-3;    // of displacements: what a step leaves is made up for as the contact moves on again
    constexpr int ticks = 20;
    const Block block;
    Motion motion = falling(1e-3);
    motion.implicit = false;
    QuasiNewton fast(block.mesh, block.materials, motion, aim, one_thread());
    Newton plain(block.mesh, block.materials, motion);
    VectorX force = Vector3(0.0, 0.0, -0.2), free(3);
    MatrixX compliance(3, 3);
    double worst = 0.0;
    for (int i = 0; i < ticks; ++i) {
        const double gone = static_cast<double>(i) / ticks;
        std::vector<NodeWeight> footprint = block.footprint(0);
        footprint[0].weight -= 0.2 * gone;
        footprint[1].weight += 0.2 * gone;
        for (Solver* each : {static_cast<Solver*>(&fast), static_cast<Solver*>(&plain)}) {
            each->place(0, footprint);
            each->predict(0.0);
            solve(*each, Forces(force.data(), 3));
            each->predict(motion.dt);
        }
        force = Vector3(0.01 * gone, 0.0, -0.2 - 0.04 * gone);    // [N] in steps of a hundredth: one iteration each
        const long long before = fast.iterations();
        fast.linearise(1, free, compliance);
        EXPECT_EQ(fast.try_step(Forces(force.data(), 3)).residual, 0.0) << i;
        EXPECT_LE(fast.iterations(), before + 1) << i;
        Vector3 mean = Vector3::Zero();
        for (const auto& [node, weight] : footprint) mean += weight * fast.displacement(node);
        EXPECT_LT((free + compliance * force - mean).norm(), 1e-6 * mean.norm()) << i;
        solve(plain, Forces(force.data(), 3));
        fast.commit();
        plain.commit();
        worst = std::max(worst, difference(block.mesh, fast, plain));
    }
    std::printf("  at worst %.1e of Newton's displacements off, aimed at %.0e\n", worst, aim);
    EXPECT_LT(worst, aim);
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

// Two threads that take turns at the tasks, from both ends.
class TwoThreads final : public Workers {
public:
    [[nodiscard]] int count() const override { return 2; }

private:
    void run(int tasks, Call call, void* context) noexcept override {
        std::thread other([=] {
            for (int i = tasks - 1; i >= 0; i -= 2) call(context, i);
        });
        for (int i = tasks - 2; i >= 0; i -= 2) call(context, i);
        other.join();
    }
};

TEST(QuasiNewton, MovesTheSameBitsOnTwoThreads) {
    const Block block;
    TwoThreads two;
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
