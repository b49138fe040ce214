// The Kelvin–Voigt damper: its forces, what it takes, and steps that it slows down.
#include "solid/newton_steps.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <numbers>

namespace stylet::corotational_fem {
namespace {

using namespace testing;

constexpr double youngs_modulus = 25e3, density = 1000.0;               // [Pa], [kg/m³]
constexpr double cell = 0.01;                                           // [m]
constexpr double energy_scale = youngs_modulus * cell * cell * cell;    // [J] E h³
constexpr double rate = 0.7;                                            // [1] τ/dt
constexpr double rounding = 1e-12;                                      // of sums over some dozen tetrahedra

class Damper : public ::testing::TestWithParam<bool> {
protected:
    Mesh mesh = jiggled(block(cell * Vector3(3.0, 2.0, 2.0), {3, 2, 2}), 0.2 * cell, 1);
    std::vector<Material> materials{elastic(youngs_modulus, 0.45)};
    Solid solid{mesh, materials, GetParam()};
    Eigen::Index size = 3 * mesh.node_count();

    // Turned by 40° and strained, at random.
    [[nodiscard]] VectorX strained(double strain, unsigned seed) const {
        const Matrix3 turned = turn(40.0, {1.0, -2.0, 0.5});
        return field(mesh, [&](const Vector3& x) { return Vector3(turned * x - x); }) + noise(size, strain * cell, seed);
    }
    VectorX forces(const VectorX& u, const VectorX& from) {
        VectorX sum = VectorX::Zero(size);
        solid.damp(u, from, rate, sum);
        return sum;
    }
    double lost(const VectorX& u, const VectorX& from) {
        VectorX unused = VectorX::Zero(size);
        return solid.damp(u, from, rate, unused);
    }
};

TEST_P(Damper, NeverGivesBackWorkAndTakesWhatItSays) {
    double least = 1.0;
    for (unsigned seed = 1; seed <= 50; ++seed) {
        const VectorX from = strained(0.3, seed), u = from + noise(size, 0.1 * cell, 200 + seed);
        EXPECT_NEAR(forces(u, from).dot(u - from), lost(u, from), rounding * lost(u, from));
        least = std::min(least, lost(u, from) / energy_scale);
    }
    std::printf("%s: 50 motions lose at least %.2e E h^3\n", pressure(GetParam()), least);
    EXPECT_GT(least, 0.0);
}

// So that a step has a function which its iterations bring down.
TEST_P(Damper, ForceIsTheDerivativeOfHalfItsLoss) {
    const VectorX from = strained(0.3, 1), u = from + noise(size, 0.3 * cell, 2), way = noise(size, 0.1 * cell, 3);
    const double found = 0.25 * (lost(u + way, from) - lost(u - way, from));    // exact for a quadratic
    EXPECT_NEAR(found, forces(u, from).dot(way), rounding * energy_scale);

    Mesh loose = mesh;
    std::fill(loose.fixed.begin(), loose.fixed.end(), char{0});
    Tangent tangent(loose, GetParam());
    solid.stiffen_damper(from, rate, tangent);
    const VectorX promised = tangent.matrix().selfadjointView<Eigen::Lower>() * way;
    EXPECT_LE((forces(u + way, from) - forces(u, from) - promised).norm(), rounding * promised.norm());
}

TEST_P(Damper, OfASmallStepIsTheElasticForceOfTheStrainItMakes) {
    const Matrix3 turned = turn(70.0, {1.0, 0.0, 2.0});
    const VectorX from = field(mesh, [&](const Vector3& x) { return Vector3(turned * x - x); });
    const VectorX u = from + noise(size, 1e-6 * cell, 4);
    VectorX elastic_forces = VectorX::Zero(size);
    solid.strain(u, elastic_forces);
    const double off = (forces(u, from) - rate * elastic_forces).norm() / (rate * elastic_forces.norm());
    std::printf("%s: damper and spring differ by %.1e at a strain of 1e-6\n", pressure(GetParam()), off);
    EXPECT_LE(off, 1e-5) << "some times the strain";
}

TEST_P(Damper, LetsABodyMoveThatKeepsItsShape) {
    const VectorX from = strained(0.1, 5);
    const VectorX u = from + field(mesh, [](const Vector3&) { return Vector3(0.1, -0.2, 0.3); });
    EXPECT_LE(forces(u, from).norm(), rounding * youngs_modulus * cell * cell);
    const auto turned_by = [&](double degrees) {
        const Matrix3 turned = turn(degrees, {0.0, 1.0, 1.0});
        return field(mesh, [&](const Vector3& x) { return Vector3(turned * x - x); });
    };
    const double one = lost(turned_by(1.0), turned_by(0.0)), two = lost(turned_by(2.0), turned_by(0.0));
    std::printf("%s: turning by 1 degree in one step loses %.1e E h^3, by 2 degrees %.1f times that\n", pressure(GetParam()),
                one / energy_scale, two / one);
    EXPECT_NEAR(two / one, 16.0, 0.1) << "1 − cos φ squared: of fourth order in what a step turns";
}

TEST_P(Damper, StepsUnderItConverge) {
    constexpr int most = 15;    // Newton's method with a fresh factor for each tenth of the residual
    int worst = 0;
    for (const double poisson_ratio : {0.45, 0.49}) {
        for (const double time : {1e-3, 10e-3}) {
            Steps steps(block(Vector3::Constant(3.0 * cell), {3, 3, 3}), {elastic(youngs_modulus, poisson_ratio, density)},
                        {.implicit = true, .damping_time = time, .share_pressure = GetParam(), .dt = 5e-3});
            for (const double force : {0.3, -0.3}) {    // [N]
                VectorX forces = VectorX::Zero(3 * steps.mesh().node_count());
                for (int i = steps.mesh().node_count() - 16; i < steps.mesh().node_count(); ++i) {
                    forces.segment<3>(3 * i) = force / 16.0 * Vector3(0.5, 0.0, -1.0);
                }
                steps.load(forces);
                for (int i = 0; i < 5; ++i) {
                    const int iterations = steps.step(5e-3);
                    ASSERT_GT(iterations, 0) << "no answer, " << steps.residual() << " N left";
                    worst = std::max(worst, iterations);
                }
            }
        }
    }
    std::printf("%s: at most %d iterations a step\n", pressure(GetParam()), worst);
    EXPECT_LE(worst, most);
}

// A column without Poisson's effect swings along its axis at ω = π/2 c/L, c² = E/ρ. A damper of stress τE ε̇ takes ζ = τω/2 of
// critical, and backward Euler as much again for τ = dt.
TEST(SwingingColumn, FadesAtItsDampersRate) {
    constexpr int cells = 10, steps_a_period = 1000;
    constexpr double length = cells * cell, speed = 5.0;    // [m], [m/s] √(E/ρ)
    const double omega = 0.5 * std::numbers::pi * speed / length, period = 2.0 * std::numbers::pi / omega;
    for (const double ratio : {0.0, 0.02, 0.05}) {
        const double damping_time = 2.0 * ratio / omega, dt = period / steps_a_period;
        Steps column(block({cell, cell, length}, {1, 1, cells}), {elastic(youngs_modulus, 0.0, density)},
                     {.implicit = true, .damping_time = damping_time, .dt = dt});
        const VectorX swing = field(column.mesh(), [&](const Vector3& x) {
            return Vector3(0.0, 0.0, 1e-3 * cell * std::sin(0.5 * std::numbers::pi * (x.z() + length) / length));
        });
        column.put(swing, 1e-5);
        const int top = column.mesh().node_count() - 1;
        const auto height = [&] { return column.newton().displacement(top).z(); };
        std::vector<double> crossings, energies;    // [s], [J]
        for (int i = 1; i <= 2 * steps_a_period; ++i) {
            const double before = height();
            ASSERT_GT(column.step(dt), 0);
            if (height() * before < 0.0) crossings.push_back(dt * (i - height() / (height() - before)));
            const EnergyReport energy = column.newton().energy();
            if (i % steps_a_period == 0) energies.push_back(energy.stored + energy.kinetic);
        }
        ASSERT_EQ(crossings.size(), 4U);
        const double found_period = crossings[2] - crossings[0];
        const double found = std::log(energies[0] / energies[1]) / (4.0 * std::numbers::pi);    // of critical
        const double expected = ratio + 0.5 * omega * dt;
        std::printf("zeta %.3f: period %.3f of %.3f ms, fades at zeta %.5f of %.5f\n", ratio, 1e3 * found_period, 1e3 * period,
                    found, expected);
        EXPECT_NEAR(found_period / period, 1.0, 0.005) << "ten linear elements and a damper that slows by ζ²/2";
        EXPECT_NEAR(found, expected, 0.01 * expected) << "a little of the swing's energy is in other modes";
    }
}

INSTANTIATE_TEST_SUITE_P(Pressure, Damper, ::testing::Bool(),
                         [](const auto& with) { return with.param ? "PerPatch" : "PerTetrahedron"; });

}    // namespace
}    // namespace stylet::corotational_fem
