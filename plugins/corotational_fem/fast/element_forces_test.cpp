// The fast forces against the plain ones of solid/solid.h, in double precision.
#include "fast/element_forces.h"

#include "fast/rest_for_tests.h"
#include "solid/solid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>
#include <vector>

namespace stylet::corotational_fem {
namespace {

constexpr double size = 0.01;    // [m] of a cell

// A beam of 5 × 1 × 1 cubes of six tetrahedra each, held at one end; 30 tetrahedra, so that the last sixteen are not full.
Mesh beam() {
    constexpr int cells = 5;
    Mesh mesh;
    const auto node = [](int i, int j, int k) { return 4 * i + 2 * j + k; };
    for (int i = 0; i <= cells; ++i) {
        for (int j = 0; j < 2; ++j) {
            for (int k = 0; k < 2; ++k) mesh.nodes.emplace_back(size * i, size * j, size * k);
        }
    }
    for (int i = 0; i < cells; ++i) {
        const int a = node(i, 0, 0), b = node(i + 1, 1, 1);
        const int ring[] = {node(i + 1, 0, 0), node(i + 1, 1, 0), node(i, 1, 0), node(i, 1, 1), node(i, 0, 1), node(i + 1, 0, 1)};
        for (int k = 0; k < 6; ++k) mesh.tetrahedra.push_back({a, ring[k], ring[(k + 1) % 6], b});
        mesh.patches.insert(mesh.patches.end(), 6, i);
        mesh.layers.insert(mesh.layers.end(), 6, i < 3 ? 0 : 1);
    }
    mesh.fixed.assign(mesh.nodes.size(), 0);
    std::fill(mesh.fixed.begin(), mesh.fixed.begin() + 4, char{1});
    return mesh;
}

const std::vector<Material> two_materials{{.shear_modulus = 8.4e3, .lame = 411e3, .density = 1000.0},
                                          {.shear_modulus = 2e3, .lame = 5e3, .density = 1000.0}};
constexpr double stress_scale = 8.4e3 * size * size;    // [N] what a strain of one does, or so

// The free nodes backwards, as an example of another order.
std::vector<int> backwards(const Mesh& mesh) {
    const int free = static_cast<int>(std::count(mesh.fixed.begin(), mesh.fixed.end(), char{0}));
    std::vector<int> places;
    int next = free;
    for (const char fixed : mesh.fixed) places.push_back(fixed != 0 ? free : --next);
    return places;
}

struct Outcome {
    VectorX forces;    // 3n [N], of mesh nodes, zero where held
    ElementSums sums;
};

class Deformed {
public:
    explicit Deformed(bool share_pressure) : share_pressure_(share_pressure) {}

    // What float makes of displacements in [m].
    [[nodiscard]] VectorX rounded(const VectorX& u) const {
        VectorX r = u.cast<float>().cast<double>();
        for (int i = 0; i < mesh_.node_count(); ++i) {
            if (mesh_.fixed[i] != 0) r.segment<3>(3 * i).setZero();
        }
        return r;
    }

    [[nodiscard]] std::vector<Float4> nodal(const VectorX& u) const {
        std::vector<Float4> v(mesh_.node_count() - 3, Float4{});    // four are held, and there is the zero node
        for (int i = 0; i < mesh_.node_count(); ++i) {
            if (mesh_.fixed[i] != 0) continue;
            const Vector3 at = u.segment<3>(3 * i);
            v[places_[i]] = {static_cast<float>(at[0]), static_cast<float>(at[1]), static_cast<float>(at[2]), 0.0F};
        }
        return v;
    }

    Outcome fast(const VectorX& u, InstructionSet set, const VectorX* from = nullptr, double rate = 0.0,
                 Workers& workers = one_thread()) const {
        ElementForces elements(mesh_, two_materials, places_, share_pressure_, from != nullptr, workers, set);
        std::vector<Float4> forces(mesh_.node_count() - 4);
        Outcome outcome{VectorX::Zero(u.size()), {}};
        if (from != nullptr) elements.start(nodal(*from).data(), forces.data());
        outcome.sums = from == nullptr ? elements.strain(nodal(u).data(), forces.data())
                                       : elements.strain(nodal(u).data(), nodal(*from).data(), rate, forces.data());
        for (int i = 0; i < mesh_.node_count(); ++i) {
            if (mesh_.fixed[i] != 0) continue;
            const Float4& f = forces[places_[i]];
            outcome.forces.segment<3>(3 * i) << f.x, f.y, f.z;
        }
        return outcome;
    }

    Outcome plain(const VectorX& u, const VectorX* from = nullptr, double rate = 0.0) const {
        Solid solid(mesh_, two_materials, share_pressure_);
        Outcome outcome{VectorX::Zero(u.size()), {}};
        outcome.sums.elastic = solid.strain(u, outcome.forces);
        if (from != nullptr) outcome.sums.dissipated = solid.damp(u, *from, rate, outcome.forces);
        for (int i = 0; i < mesh_.node_count(); ++i) {
            if (mesh_.fixed[i] != 0) outcome.forces.segment<3>(3 * i).setZero();
        }
        return outcome;
    }

    [[nodiscard]] VectorX random(double strain, unsigned seed) const {
        std::mt19937 generator(seed);
        std::uniform_real_distribution<double> any(-1.0, 1.0);
        VectorX u(3 * mesh_.node_count());
        for (int i = 0; i < u.size(); ++i) u[i] = strain * size * any(generator);
        return rounded(u);
    }

    [[nodiscard]] const Mesh& mesh() const { return mesh_; }

private:
    Mesh mesh_ = beam();
    std::vector<int> places_ = backwards(mesh_);
    bool share_pressure_;
};

double difference(const VectorX& a, const VectorX& b) {
    return (a - b).lpNorm<Eigen::Infinity>();
}

// Forces that a rounding of the displacements' own size in float would make, times ten.
double resolution(const VectorX& u) {
    return 10.0 * 6e-8 * 50.0 * stress_scale * u.lpNorm<Eigen::Infinity>() / size;
}

class EachSet : public ::testing::TestWithParam<InstructionSet> {
protected:
    void SetUp() override {
        if (!supported(GetParam())) GTEST_SKIP() << "this processor has no " << name(GetParam());
    }
};

INSTANTIATE_TEST_SUITE_P(ElementForces, EachSet,
                         ::testing::Values(InstructionSet::sse2, InstructionSet::avx2, InstructionSet::avx512));

TEST_P(EachSet, AgreesWithThePlainForcesAtStrainsFromAMillionthToAHalf) {
    constexpr double close = 1e-5;    // of the greatest force: single precision and its sums
    for (const bool shared : {false, true}) {
        const Deformed beam(shared);
        for (const double strain : {1e-7, 1e-6, 1e-5, 1e-4, 1e-3, 0.01, 0.03, 0.1, 0.2, 0.3, 0.5}) {
            double worst = 0.0, worst_energy = 0.0;
            for (unsigned seed = 0; seed < 20; ++seed) {
                const VectorX u = beam.random(strain, seed);
                const Outcome fast = beam.fast(u, GetParam()), plain = beam.plain(u);
                worst = std::max(worst, difference(fast.forces, plain.forces) / plain.forces.lpNorm<Eigen::Infinity>());
                worst_energy = std::max(worst_energy, std::abs(fast.sums.elastic / plain.sums.elastic - 1.0));
            }
            std::printf("  %s strain %.0e: forces differ by %.1e, energy by %.1e\n", shared ? "shared" : "own", strain, worst,
                        worst_energy);
            EXPECT_LT(worst, close) << strain;
            EXPECT_LT(worst_energy, close) << strain;
        }
    }
}

TEST_P(EachSet, AgreesWithThePlainForcesOfInvertedTetrahedra) {
    constexpr double close = 1e-4;    // of the greatest force: near a tie of two stretches the rotation itself is uncertain
    for (const bool shared : {false, true}) {
        const Deformed beam(shared);
        for (const double strain : {0.8, 1.5, 5.0, 100.0}) {
            for (unsigned seed = 0; seed < 20; ++seed) {
                const VectorX u = beam.random(strain, seed);
                const Outcome fast = beam.fast(u, GetParam()), plain = beam.plain(u);
                EXPECT_LT(difference(fast.forces, plain.forces), close * plain.forces.lpNorm<Eigen::Infinity>())
                    << strain << " " << seed;
            }
        }
    }
}

// All nodes to A x, the held ones too: a beam of its own whose held end is forgotten would be no different in its free part.
VectorX mapped(const Deformed& beam, const Matrix3& a) {
    VectorX u(3 * beam.mesh().node_count());
    for (int i = 0; i < beam.mesh().node_count(); ++i) u.segment<3>(3 * i) = a * beam.mesh().nodes[i] - beam.mesh().nodes[i];
    return u;
}

TEST_P(EachSet, PushesBackWhatIsFlatMirroredOrCollapsed) {
    constexpr double close = 1e-4;    // of a strain of one
    const Deformed beam(false);
    for (const Vector3& stretch : {Vector3(1, 1, 1e-3), Vector3(1, 1, 1e-7), Vector3(1, 1, -0.2), Vector3(1.1, 0.9, -0.8),
                                   Vector3(0.5, 2e-2, -1e-3), Vector3(3.0, 0.2, 0.1), Vector3(0.3, 0.2, 0.1)}) {
        const VectorX u = beam.rounded(mapped(beam, stretch.asDiagonal()));
        const Outcome fast = beam.fast(u, GetParam()), plain = beam.plain(u);
        EXPECT_LT(difference(fast.forces, plain.forces), close * 50.0 * stress_scale) << stretch.transpose();
    }
    for (const Matrix3& a : {Matrix3(Matrix3::Zero()), Matrix3(-Matrix3::Identity()), Matrix3(1e18 * Matrix3::Identity())}) {
        const VectorX u = beam.rounded(mapped(beam, a));
        const Outcome fast = beam.fast(u, GetParam()), again = beam.fast(u, GetParam());
        EXPECT_TRUE(fast.forces.allFinite());
        EXPECT_EQ(fast.forces, again.forces);
    }
}

TEST_P(EachSet, TellsWhetherATetrahedronIsInsideOut) {
    for (const bool shared : {false, true}) {
        const Deformed beam(shared);
        EXPECT_FALSE(beam.fast(beam.random(0.1, 1), GetParam()).sums.inverted);
        EXPECT_FALSE(beam.fast(mapped(beam, Vector3(1, 1, 1e-3).asDiagonal()), GetParam()).sums.inverted);
        VectorX u = beam.random(0.1, 1);
        u[3 * 20] -= 2.0 * size;    // the end node x, beyond its neighbours
        EXPECT_TRUE(beam.fast(u, GetParam()).sums.inverted);
    }
}

TEST_P(EachSet, HasNoForceInATurnOfTheWhole) {
    const Deformed beam(false);
    double worst = 0.0;
    for (const Vector3& about : {Vector3(1, 0, 0), Vector3(0, 1, 0), Vector3(0, 0, 1), Vector3(0.6, 0, 0.8), Vector3(1, 1, 1)}) {
        for (int degrees = 0; degrees <= 360; degrees += 5) {
            const Matrix3 turn = Eigen::AngleAxisd(degrees * 3.14159265358979 / 180.0, about.normalized()).matrix();
            const VectorX u = mapped(beam, turn);
            // Of the nodes whose tetrahedra are all free to turn.
            const VectorX forces = beam.fast(u, GetParam()).forces.tail(3 * 4 * 4);
            EXPECT_LT(forces.lpNorm<Eigen::Infinity>(), 1e-12 + resolution(u)) << degrees << " about " << about.transpose();
            worst = std::max(worst, forces.lpNorm<Eigen::Infinity>());
        }
    }
    std::printf("  greatest force %.1e of that of a strain of one\n", worst / (50.0 * stress_scale));
}

TEST_P(EachSet, DampsAsThePlainModelDoes) {
    constexpr double close = 1e-4;    // of the greatest force: the change of displacement is a difference in float
    constexpr double rate = 0.7;      // τ/dt
    for (const bool shared : {false, true}) {
        const Deformed beam(shared);
        for (const double strain : {1e-4, 0.05, 0.3}) {
            const VectorX u = beam.random(strain, 1), from = beam.random(strain, 2);
            const Outcome fast = beam.fast(u, GetParam(), &from, rate), plain = beam.plain(u, &from, rate);
            EXPECT_LT(difference(fast.forces, plain.forces), close * plain.forces.lpNorm<Eigen::Infinity>()) << strain;
            EXPECT_NEAR(fast.sums.dissipated, plain.sums.dissipated, close * plain.sums.dissipated) << strain;
        }
    }
}

TEST_P(EachSet, GivesTheSameBitsOnAnyNumberOfThreads) {
    for (const bool shared : {false, true}) {
        const Deformed beam(shared);
        const VectorX u = beam.random(0.6, 3), from = beam.random(0.6, 4);    // some inverted
        const Outcome alone = beam.fast(u, GetParam(), &from, 0.5);
        for (const int threads : {2, 3}) {
            testing::Threads workers(threads);
            const Outcome together = beam.fast(u, GetParam(), &from, 0.5, workers);
            EXPECT_EQ(alone.forces, together.forces);
            EXPECT_EQ(alone.sums.elastic, together.sums.elastic);
            EXPECT_EQ(alone.sums.dissipated, together.sums.dissipated);
        }
    }
}

TEST_P(EachSet, IsTheDerivativeOfItsEnergy) {
    constexpr double step = 0.02;     // [1] of strain: a difference of float energies needs a large one
    constexpr double close = 2e-3;    // of the greatest force: its square, and what float loses
    for (const bool shared : {false, true}) {
        const Deformed beam(shared);
        const VectorX u = beam.random(0.15, 5);
        const VectorX forces = beam.fast(u, GetParam()).forces;
        for (int i = 12; i < u.size(); i += 7) {
            const auto energy = [&](double steps) {
                VectorX moved = u;
                moved[i] += steps * step * size;
                return beam.fast(moved, GetParam()).sums.elastic;
            };
            const double slope = (8.0 * (energy(0.5) - energy(-0.5)) - (energy(1.0) - energy(-1.0))) / (6.0 * step * size);
            EXPECT_NEAR(forces[i], slope, close * forces.lpNorm<Eigen::Infinity>()) << i;
        }
    }
}

TEST(CarefulRotation, IsAProperRotationWhateverComes) {
    constexpr float orthogonal = 1e-6F;    // of single precision
    std::mt19937 generator(1);
    std::uniform_real_distribution<float> any(-2.0F, 2.0F);
    using Rows = Eigen::Matrix<float, 3, 3, Eigen::RowMajor>;
    for (int trial = 0; trial < 1000; ++trial) {
        Rows gradient = Rows::NullaryExpr([&] { return any(generator); });
        if (trial == 0) gradient = -Rows::Identity();                                                                 // collapsed
        if (trial == 1) gradient = -2.0F * Rows::Identity();                                                          // mirrored
        if (trial % 5 == 2) gradient.col(1) = gradient.col(0) + Rows::Identity().col(0) - Rows::Identity().col(1);    // flat
        Rows difference;
        careful_rotation(gradient.data(), difference.data());
        const Rows rotation = Rows::Identity() + difference;
        EXPECT_LT((rotation * rotation.transpose() - Rows::Identity()).norm(), orthogonal);
        EXPECT_GT(rotation.determinant(), 0.0F);
    }
}

TEST(CarefulRotation, OfWhatIsNotANumberIsNone) {
    float gradient[9] = {}, rotation[9];
    gradient[4] = NAN;
    careful_rotation(gradient, rotation);
    for (const float entry : rotation) EXPECT_EQ(entry, 0.0F);
}

}    // namespace
}    // namespace stylet::corotational_fem
