#include "solid/newton.h"

#include "solid/newton_steps.h"

#include <stylet/error.h>

#include <gtest/gtest.h>

#include <cstdio>
#include <cstring>

namespace stylet::corotational_fem {
namespace {

using namespace testing;

constexpr double youngs_modulus = 25e3, density = 1000.0;    // [Pa], [kg/m³]
constexpr double cell = 0.01;                                // [m]
// [m] what Newton::tolerance at every node of a body of a few cells leaves, for its softest motions are some dozen times softer
// than a cell, E h
constexpr double converged = 100.0 * Newton::tolerance / (youngs_modulus * cell);

Mesh cube(int cells) {
    return block(Vector3::Constant(cells * cell), {cells, cells, cells});
}

std::vector<Material> gel(double poisson_ratio) {
    return {elastic(youngs_modulus, poisson_ratio, density)};
}

/// A force [N] shared by the nodes of the top.
VectorX on_top(const Mesh& mesh, const Vector3& force) {
    VectorX forces = VectorX::Zero(3 * mesh.node_count());
    int count = 0;
    for (const Vector3& x : mesh.nodes) count += x.z() > -1e-9 ? 1 : 0;
    for (int i = 0; i < mesh.node_count(); ++i) {
        if (mesh.nodes[i].z() > -1e-9) forces.segment<3>(3 * i) = force / count;
    }
    return forces;
}

class NewtonTest : public ::testing::TestWithParam<bool> {};

TEST_P(NewtonTest, ComesToRestWhereAnotherNewtonsMethodDoes) {
    const Mesh mesh = jiggled(cube(4), 0.15 * cell, 5);
    const VectorX forces = on_top(mesh, {0.6, 0.2, -3.5});    // some tenths of the height
    Steps steps(mesh, gel(0.45), {.share_pressure = GetParam(), .dt = 1e-3});
    steps.load(forces);
    const int iterations = steps.step(1e-3);
    const VectorX u = steps.displacements();

    Supported other(mesh, gel(0.45).front(), GetParam());
    for (int i = 0; i < mesh.node_count(); ++i) {
        if (mesh.fixed[i] != 0) other.hold(i, Vector3::Zero());
    }
    const VectorX expected = other.settle(VectorX::Zero(u.size()), forces, 0.1 * Newton::tolerance);
    std::printf("%s: %d iterations, %d factorisations; moves by %.1f mm, differs by %.1e mm\n", pressure(GetParam()), iterations,
                steps.newton().factorisations(), 1e3 * u.lpNorm<Eigen::Infinity>(),
                1e3 * (u - expected).lpNorm<Eigen::Infinity>());
    EXPECT_GT(iterations, 0);
    EXPECT_LE((u - expected).lpNorm<Eigen::Infinity>(), converged);
}

struct Contacts {
    explicit Contacts(Steps& steps) {
        const int top = steps.mesh().node_count() - 1;
        steps.newton().place(0, std::vector<NodeWeight>{{top, 0.5}, {top - 1, 0.3}, {top - 2, 0.2}});
        steps.newton().place(1, std::vector<NodeWeight>{{top - 3, 1.0}});
        footprints = {{{top, 0.5}, {top - 1, 0.3}, {top - 2, 0.2}}, {{top - 3, 1.0}}};
    }
    [[nodiscard]] VectorX means(const Steps& steps) const {
        VectorX means = VectorX::Zero(6);
        const VectorX u = steps.displacements();
        for (int i = 0; i < 2; ++i) {
            for (const auto& [node, weight] : footprints[i]) means.segment<3>(3 * i) += weight * u.segment<3>(3 * node);
        }
        return means;
    }
    std::vector<std::vector<NodeWeight>> footprints;
};

TEST_P(NewtonTest, LinearisationSaysWhereContactsGoWithAndWithoutForces) {
    for (const bool implicit : {false, true}) {
        Steps steps(cube(3), gel(0.45), {.implicit = implicit, .share_pressure = GetParam(), .dt = 10e-3});
        const Contacts contacts(steps);
        VectorX forces(6);
        forces << 0.1, 0.2, -0.4, 0.0, -0.1, -0.2;    // [N]
        EXPECT_GT(steps.solve(10e-3, forces), 0);
        VectorX free(6);
        MatrixX compliance(6, 6);
        steps.newton().linearise(2, free, compliance);    // whose factor may be an earlier iteration's
        EXPECT_EQ(compliance, compliance.transpose());
        EXPECT_GT(Eigen::SelfAdjointEigenSolver<MatrixX>(compliance).eigenvalues().minCoeff(), 0.0);
        const VectorX at = contacts.means(steps);
        EXPECT_LE((free + compliance * forces - at).norm(), converged) << "in balance, it says where the contacts are";
        steps.newton().commit();

        constexpr double little = 1e-6;    // of the forces
        steps.newton().predict(0.0);
        VectorX more = (1.0 + little) * forces;
        for (int i = 0; i < 20; ++i) {
            steps.newton().linearise(2, free, compliance);
            if (steps.newton().try_step(Forces(more.data(), 6)).residual == 0.0) break;
        }
        const VectorX moved = contacts.means(steps) - at, promised = little * compliance * forces;
        std::printf("%s, %s: a millionth more force moves contacts by %.4f nm, promised %.4f\n", pressure(GetParam()),
                    implicit ? "implicit" : "quasi-static", 1e9 * moved.norm(), 1e9 * promised.norm());
        // The factor is that of a state a tenth of the last residual away, no nearer.
        EXPECT_LE((moved - promised).norm(), 0.01 * promised.norm());
    }
}

// About a body at rest the factor is that of the very state: the prediction is off by the square of the displacement alone.
TEST_P(NewtonTest, SmallForcesOnABodyAtRestMoveItAsPredicted) {
    for (const bool implicit : {false, true}) {
        Steps steps(cube(3), gel(0.45), {.implicit = implicit, .share_pressure = GetParam(), .dt = 10e-3});
        const Contacts contacts(steps);
        VectorX forces(6), free(6);
        forces << 1e-6, 2e-6, -4e-6, 0.0, -1e-6, -2e-6;    // [N]
        MatrixX compliance(6, 6);
        steps.newton().predict(10e-3);
        steps.newton().linearise(2, free, compliance);
        const VectorX promised = free + compliance * forces;
        (void)steps.newton().try_step(Forces(forces.data(), 6));
        const double off = (contacts.means(steps) - promised).norm() / promised.norm();
        std::printf("%s, %s: moved as predicted but for %.1e\n", pressure(GetParam()), implicit ? "implicit" : "quasi-static",
                    off);
        EXPECT_LE(off, 1e-12) << "one linear solve, rounded";
    }
}

TEST_P(NewtonTest, RollsBackToTheLastBit) {
    Steps steps(cube(3), gel(0.49), {.implicit = true, .damping_time = 0.01, .share_pressure = GetParam(), .dt = 5e-3});
    steps.load(on_top(steps.mesh(), {0.2, 0.0, -1.0}));
    for (int i = 0; i < 5; ++i) (void)steps.step(5e-3);
    const VectorX before = steps.displacements();
    const EnergyReport books = steps.newton().energy();
    steps.load(on_top(steps.mesh(), {-3.0, 0.0, 2.0}));
    (void)steps.solve(5e-3);
    EXPECT_NE(steps.displacements(), before);
    steps.newton().rollback();
    EXPECT_EQ(steps.displacements(), before);
    const EnergyReport again = steps.newton().energy();
    EXPECT_EQ(std::memcmp(&again, &books, sizeof(EnergyReport)), 0);
}

TEST_P(NewtonTest, AStepOfNoTimeIsTheLastOneAgain) {
    Steps steps(cube(3), gel(0.49), {.implicit = true, .share_pressure = GetParam(), .dt = 5e-3});
    steps.load(on_top(steps.mesh(), {0.2, 0.0, -1.0}));
    for (int i = 0; i < 5; ++i) (void)steps.step(5e-3);
    const VectorX before = steps.displacements();
    (void)steps.step(0.0);
    EXPECT_LE((steps.displacements() - before).lpNorm<Eigen::Infinity>(), converged);
}

TEST(Newton, AColumnWithoutPoissonsEffectShortensByItsLoad) {
    for (const double strain : {-0.3, -1e-4, 0.2}) {
        const Mesh mesh = block(cell * Vector3(1.0, 1.0, 4.0), {1, 1, 4});
        Steps steps(mesh, gel(0.0), {.dt = 1e-3});
        VectorX forces = VectorX::Zero(3 * mesh.node_count());
        const int top = mesh.node_count() - 4;
        const double share[] = {1.0 / 3.0, 1.0 / 6.0, 1.0 / 6.0, 1.0 / 3.0};    // of the face's two triangles
        for (int i = 0; i < 4; ++i) forces[3 * (top + i) + 2] = share[i] * youngs_modulus * cell * cell * strain;
        steps.load(forces);
        EXPECT_GT(steps.step(1e-3), 0);
        const double found = steps.newton().displacement(top).z() / (4.0 * cell);
        std::printf("p/E = %g: strain off by %.1e\n", strain, found - strain);
        EXPECT_NEAR(found, strain, converged / cell);
    }
}

TEST(Newton, FallsFreelyAsBackwardEulerDoes) {
    Mesh mesh = cube(2);
    std::fill(mesh.fixed.begin(), mesh.fixed.end(), char{0});
    constexpr double dt = 10e-3, gravity = 9.81;
    Steps steps(mesh, gel(0.45), {.implicit = true, .gravity = {0.0, 0.0, -gravity}, .dt = dt});
    double worst = 0.0;
    for (int n = 1; n <= 20; ++n) {
        EXPECT_GT(steps.step(dt), 0);
        const double fallen = 0.5 * gravity * dt * dt * n * (n + 1);
        for (int i = 0; i < mesh.node_count(); ++i) {
            worst = std::max(worst, (steps.newton().displacement(i) + Vector3(0.0, 0.0, fallen)).norm() / fallen);
        }
    }
    std::printf("20 steps of free fall: off by %.1e\n", worst);
    EXPECT_LE(worst, 1e-8) << "each step's imbalance of 1e-10 N at nodes of some 0.1 g adds up";
}

TEST(Newton, LongStepsOfInertiaEndWhereThereIsNone) {
    const Vector3 gravity(0.0, 0.0, -9.81);
    Steps moving(cube(3), gel(0.45), {.implicit = true, .gravity = gravity, .dt = 1.0});
    Steps still(cube(3), gel(0.45), {.gravity = gravity, .dt = 1.0});
    const VectorX forces = on_top(moving.mesh(), {0.5, 0.0, -2.0});
    moving.load(forces);
    still.load(forces);
    for (int i = 0; i < 12; ++i) (void)moving.step(1.0);
    (void)still.step(1.0);
    const double off = (moving.displacements() - still.displacements()).lpNorm<Eigen::Infinity>();
    std::printf("twelve steps of 1 s: off the quasi-static answer by %.1e mm\n", 1e3 * off);
    EXPECT_LE(off, converged);
}

TEST(Newton, RefusesInertiaAndWeightWithoutADensity) {
    const std::vector<Material> weightless{elastic(youngs_modulus, 0.3)};
    EXPECT_NO_THROW(Steps(cube(1), weightless, {.dt = 1e-3}));
    for (const Motion& motion : {Motion{.implicit = true, .dt = 1e-3}, Motion{.gravity = {0.0, 0.0, -9.81}, .dt = 1e-3}}) {
        try {
            const Steps steps(cube(1), weightless, motion);
            FAIL() << "a layer without density was taken";
        } catch (const Error& error) {
            EXPECT_EQ(error.key(), "layers");
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Pressure, NewtonTest, ::testing::Bool(),
                         [](const auto& with) { return with.param ? "PerPatch" : "PerTetrahedron"; });

}    // namespace
}    // namespace stylet::corotational_fem
