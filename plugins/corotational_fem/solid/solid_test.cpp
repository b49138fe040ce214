// Forces, energy and tangent of the co-rotational solid against each other.
#include "solid/solid.h"

#include "solid/test_solids.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

namespace stylet::corotational_fem {
namespace {

using namespace testing;

constexpr double youngs_modulus = 25e3;                         // [Pa]
constexpr double cell = 0.01;                                   // [m]
constexpr double force_scale = youngs_modulus * cell * cell;    // [N] E h²
constexpr double epsilon = std::numeric_limits<double>::epsilon();

class SolidTest : public ::testing::TestWithParam<bool> {
protected:
    static constexpr Cells cells = {3, 2, 2};

    Mesh mesh = jiggled(block(cell * Vector3(3.0, 2.0, 2.0), cells), 0.2 * cell, 1);
    std::vector<Material> materials{elastic(youngs_modulus, 0.45)};
    Solid solid{mesh, materials, GetParam()};

    // Turned by 40° and strained by about this much, at random.
    [[nodiscard]] VectorX strained(double strain, unsigned seed) const {
        const Matrix3 turned = turn(40.0, {1.0, -2.0, 0.5});
        const VectorX turning = field(mesh, [&](const Vector3& x) { return Vector3(turned * x - x); });
        return turning + noise(turning.size(), strain * cell, seed);
    }
    double energy(const VectorX& u) {
        VectorX unused = VectorX::Zero(u.size());
        return solid.strain(u, unused);
    }
    VectorX forces(const VectorX& u) {
        VectorX sum = VectorX::Zero(u.size());
        solid.strain(u, sum);
        return sum;
    }
    MatrixX tangent(const VectorX& u, Twists twists) {
        Mesh loose = mesh;
        std::fill(loose.fixed.begin(), loose.fixed.end(), char{0});
        Tangent sum(loose, GetParam());
        solid.stiffen(u, twists, sum);
        return MatrixX(MatrixX(sum.matrix()).selfadjointView<Eigen::Lower>());
    }
};

constexpr double strains[] = {1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 1e-1, 0.5};

// A strain ε is known to 1e-16/ε of itself, for it is F − R, and a central difference over a thousandth of it to a thousand times
// that. It leaves out the third derivative: the square of the change of F, which counts for more where F is nearly inverted, as
// some tetrahedra are at ε = 0.5.
constexpr double part = 1e-3;    // of the strain, by which it is changed

double difference_quotient(double strain) {
    return 10.0 * epsilon / (strain * part) + 100.0 * part * part * strain * strain;
}

TEST_P(SolidTest, ForceIsMinusTheEnergysDerivative) {
    for (const double strain : strains) {
        double worst = 0.0;
        for (unsigned seed = 1; seed <= 20; ++seed) {
            const VectorX u = strained(strain, seed);
            const VectorX way = noise(u.size(), cell * strain * part, 100 + seed);
            const double found = 0.5 * (energy(u + way) - energy(u - way));
            const VectorX inner = forces(u);
            worst = std::max(worst, std::abs(found - inner.dot(way)) / (inner.norm() * way.norm()));
        }
        std::printf("%s, strain %.0e: dE/du off by %.1e of |f| (allowed %.1e)\n", pressure(GetParam()), strain, worst,
                    difference_quotient(strain));
        EXPECT_LE(worst, difference_quotient(strain));
    }
}

TEST_P(SolidTest, EnergyOfAnAffineStrainIsItsDensityTimesTheVolume) {
    const Matrix3 stretched = Vector3(1.2, 0.9, 1.05).asDiagonal();
    const Matrix3 turned = turn(100.0, {1.0, 2.0, -1.0}), axes = turn(50.0, {0.0, 1.0, 3.0});
    const Matrix3 deformation = turned * axes * stretched * axes.transpose();
    const double theta = 0.2 - 0.1 + 0.05, squares = 0.2 * 0.2 + 0.1 * 0.1 + 0.05 * 0.05, volume = 12.0 * cell * cell * cell;
    const double expected = volume * (materials[0].shear_modulus * squares + 0.5 * materials[0].lame * theta * theta);    // [J]
    const double found = energy(field(mesh, [&](const Vector3& x) { return Vector3(deformation * x - x); }));
    std::printf("%s: energy %.12f mJ of %.12f\n", pressure(GetParam()), 1e3 * found, 1e3 * expected);
    EXPECT_NEAR(found, expected, 1e-12 * expected) << "sums of some dozen tetrahedra";
}

TEST_P(SolidTest, TangentIsTheForcesDerivative) {
    for (const double strain : strains) {
        double worst = 0.0;
        for (unsigned seed = 1; seed <= 20; ++seed) {
            const VectorX u = strained(strain, seed);
            const VectorX way = noise(u.size(), cell * strain * part, 100 + seed);
            const VectorX found = 0.5 * (forces(u + way) - forces(u - way));
            const VectorX promised = tangent(u, Twists::exact) * way;
            worst = std::max(worst, (found - promised).norm() / promised.norm());
        }
        std::printf("%s, strain %.0e: df/du off by %.1e (allowed %.1e)\n", pressure(GetParam()), strain, worst,
                    difference_quotient(strain));
        EXPECT_LE(worst, difference_quotient(strain));
    }
}

TEST_P(SolidTest, DefiniteTangentIsTheExactOneWhereNoTwistIsFree) {
    const VectorX swollen = field(mesh, [](const Vector3& x) { return Vector3(0.1 * x); });
    const VectorX u = swollen + noise(swollen.size(), 1e-3 * cell, 5);
    EXPECT_EQ(tangent(u, Twists::definite), tangent(u, Twists::exact));
}

// Hard case 5: what compression does to the tangent.
TEST_P(SolidTest, DefiniteTangentHasNoNegativeEigenvalueWhereTheExactOneHas) {
    const VectorX u = field(mesh, [](const Vector3& x) { return Vector3(-0.4 * x.x(), 0.0, -0.3 * x.z()); });
    const auto least = [&](Twists twists) {
        return Eigen::SelfAdjointEigenSolver<MatrixX>(tangent(u, twists), Eigen::EigenvaluesOnly).eigenvalues().minCoeff();
    };
    const double stiffness = youngs_modulus * cell;    // [N/m]
    constexpr double rounded = 1e-12;                  // of the stiffness: an eigenvalue of a 100 × 100 matrix
    const double exact = least(Twists::exact) / stiffness, definite = least(Twists::definite) / stiffness;
    std::printf("%s, pressed to 0.6 x 1 x 0.7: least eigenvalue/(E h): exact %.3f, definite %.1e\n", pressure(GetParam()), exact,
                definite);
    EXPECT_LT(exact, -0.01);
    EXPECT_GE(definite, -100.0 * rounded);
}

// validation.md: ‖f‖ ≤ 1e-9 E h².
TEST_P(SolidTest, ARigidMotionPullsAtNothing) {
    constexpr double rigid = 1e-9;
    double worst = 0.0, most = 0.0;
    for (const Vector3& axis : {Vector3(1, 0, 0), Vector3(0, 1, 0), Vector3(0, 0, 1), Vector3(1, 1, 1), Vector3(-3, 1, 2)}) {
        for (int degrees = 0; degrees <= 360; degrees += 5) {
            const Matrix3 turned = turn(degrees, axis);
            const VectorX u = field(mesh, [&](const Vector3& x) { return Vector3(turned * x - x + Vector3(0.3, -0.2, 0.1)); });
            worst = std::max(worst, forces(u).norm() / force_scale);
            most = std::max(most, energy(u) / (force_scale * cell));
        }
    }
    std::printf("%s, turned by 0..360 degrees about 5 axes: |f| <= %.1e E h^2, energy <= %.1e E h^3\n", pressure(GetParam()),
                worst, most);
    EXPECT_LE(worst, rigid);
    EXPECT_LE(most, rigid * rigid);
}

TEST_P(SolidTest, InnerForcesAndMomentsCancel) {
    double force = 0.0, moment = 0.0;
    for (unsigned seed = 1; seed <= 20; ++seed) {
        const VectorX u = strained(0.5, seed);
        const VectorX inner = forces(u);
        Vector3 pulls = Vector3::Zero(), turns = Vector3::Zero();
        for (int i = 0; i < mesh.node_count(); ++i) {
            pulls += inner.segment<3>(3 * i);
            turns += (mesh.nodes[i] + u.segment<3>(3 * i)).cross(inner.segment<3>(3 * i));
        }
        force = std::max(force, pulls.norm() / inner.norm());
        moment = std::max(moment, turns.norm() / (inner.norm() * cell));
    }
    constexpr double sums = 1e-13;    // of a hundred terms, rounded
    std::printf("%s, strain 0.5: forces add up to %.1e of |f|, moments to %.1e of |f| h\n", pressure(GetParam()), force, moment);
    EXPECT_LE(force, sums);
    EXPECT_LE(moment, sums);
}

// Hard cases 1 and 3.
TEST_P(SolidTest, FlatInvertedAndCollapsedTetrahedraPushWithFiniteForces) {
    for (const double z : {1e-4, 1e-14, 0.0, -0.2, -1.0}) {
        const VectorX u = field(mesh, [&](const Vector3& x) { return Vector3(0.0, 0.0, (z - 1.0) * x.z()); });
        const VectorX inner = forces(u);
        EXPECT_TRUE(inner.allFinite());
        EXPECT_TRUE(tangent(u, Twists::exact).allFinite());
        EXPECT_LE(inner.norm(), 100.0 * force_scale) << "a strain of two, at a few dozen nodes";
        EXPECT_LT(inner.dot(field(mesh, [](const Vector3& x) { return Vector3(0.0, 0.0, x.z()); })), 0.0) << "pushed back";
        std::printf("%s, z x %.0e: |f| = %.2f E h^2\n", pressure(GetParam()), z, inner.norm() / force_scale);
    }
    const VectorX collapsed = field(mesh, [](const Vector3& x) { return Vector3(-x); });
    EXPECT_TRUE(forces(collapsed).allFinite());
    EXPECT_TRUE(tangent(collapsed, Twists::definite).allFinite());
    EXPECT_EQ(forces(collapsed), forces(collapsed));
}

INSTANTIATE_TEST_SUITE_P(Pressure, SolidTest, ::testing::Bool(),
                         [](const auto& with) { return with.param ? "PerPatch" : "PerTetrahedron"; });

/// Hard case 35. Without shared pressure, taking one away changes the forces of its own four nodes alone.
TEST(Solid, ATetrahedronActsOnItsOwnNodesAlone) {
    const Mesh whole = block(cell * Vector3(3.0, 2.0, 2.0), {3, 2, 2});
    Mesh less = whole;
    const Tetrahedron gone = less.tetrahedra.back();
    less.tetrahedra.pop_back();
    less.layers.pop_back();
    less.patches.pop_back();
    const std::vector<Material> materials{elastic(youngs_modulus, 0.45)};
    const VectorX u = noise(3 * whole.node_count(), 0.1 * cell, 1);
    VectorX with = VectorX::Zero(u.size()), without = with;
    (void)Solid(whole, materials, false).strain(u, with);
    (void)Solid(less, materials, false).strain(u, without);
    for (int node = 0; node < whole.node_count(); ++node) {
        const bool touched = std::find(gone.begin(), gone.end(), node) != gone.end();
        const Vector3 change = with.segment<3>(3 * node) - without.segment<3>(3 * node);
        EXPECT_EQ(change.isZero(0.0), !touched) << "node " << node;
    }
}

}    // namespace
}    // namespace stylet::corotational_fem
