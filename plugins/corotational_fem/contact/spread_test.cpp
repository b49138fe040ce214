#include "contact/spread.h"

#include "contact/test_needles.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <random>
#include <set>

namespace stylet::corotational_fem {
namespace {

using namespace testing;

constexpr double edge = 10e-3;        // [m] of the cubes
constexpr double radius = 0.3e-3;     // [m] of the needle
constexpr double rounding = 1e-12;    // relative: a sum over a hundred nodes

Mesh cubes() {
    return block_mesh(block_of({0.1, 0.1, 0.05}, 25e3, 0.45), {10, 10, 5});
}

/// Cells that grow away from one corner of the top, five times as long at the other end.
Mesh graded() {
    Mesh mesh = cubes();
    for (Vector3& x : mesh.nodes) {
        const double t = x.x() / 0.1 + 0.5;
        x.x() = 0.1 * (t * (0.2 + 0.8 * t) - 0.5);
    }
    return mesh;
}

ContactPoint some_contact(std::mt19937& random) {
    std::uniform_real_distribution<double> across(-0.05, 0.05), down(-0.05, 0.0), pick(0.0, 1.0);
    const Vector3 at(across(random), across(random), down(random)), to(across(random), across(random), down(random));
    return pick(random) < 0.5 ? tip_at(at) : shaft(at, at + pick(random) * (to - at));
}

TEST(Spread, SharesAContactAmongNodesEachOnce) {
    std::mt19937 random(1);
    for (const Mesh& mesh : {cubes(), graded()}) {
        Spread spread(mesh, radius);
        std::size_t fewest = mesh.nodes.size(), most = 0;
        for (int i = 0; i < 300; ++i) {
            const auto weights = spread.of(some_contact(random));
            double sum = 0.0;
            std::set<int> nodes;
            for (const auto& [node, weight] : weights) {
                EXPECT_GT(weight, 0.0);
                sum += weight;
                nodes.insert(node);
            }
            EXPECT_NEAR(sum, 1.0, rounding);
            EXPECT_EQ(nodes.size(), weights.size());
            fewest = std::min(fewest, weights.size());
            most = std::max(most, weights.size());
        }
        std::printf("%zu to %zu nodes carry a contact\n", fewest, most);
        EXPECT_GE(fewest, 8U) << "fewer don't answer alike wherever the contact is";
    }
}

TEST(Spread, IsCentredOnItsContact) {
    const Mesh mesh = cubes();
    Spread spread(mesh, radius);
    std::mt19937 random(2);
    std::uniform_real_distribution<double> across(-0.03, 0.03), down(-0.03, -0.02);
    double worst = 0.0;    // [m]
    for (int i = 0; i < 300; ++i) {
        const Vector3 at(across(random), across(random), down(random));
        Vector3 centre = Vector3::Zero();
        for (const auto& [node, weight] : spread.of(tip_at(at))) centre += weight * mesh.nodes[node];
        worst = std::max(worst, (centre - at).norm());
    }
    std::printf("the nodes' centre is at most %.3f edges beside the contact\n", worst / edge);
    constexpr double lattice = 0.05;    // measured 0.03: what a lattice two edges wide leaves of a smooth density
    EXPECT_LE(worst, lattice * edge);
}

TEST(Spread, ChangesSmoothlyWhileItsContactMoves) {
    const Mesh mesh = graded();
    Spread spread(mesh, radius);
    const double step = 1e-5;    // [m]
    VectorX last;
    for (int i = 0; i < 2000; ++i) {
        const Vector3 at = Vector3(-0.045, -0.04, 0.0) + i * step * Vector3(1.0, 0.7, -1.0);
        VectorX now = VectorX::Zero(mesh.node_count());
        for (const auto& [node, weight] : spread.of(tip_at(at))) now[node] = weight;
        // A weight's slope is at most about that of φ over its sum, 1.5/ρ of the largest; the finest cells have ρ = 7 mm.
        constexpr double steepest = 600.0;    // [1/m]
        if (i > 0) {
            EXPECT_LE((now - last).lpNorm<Eigen::Infinity>(), steepest * step);
        }
        last = now;
    }
}

TEST(Spread, IsAsWideAsTheTetrahedraThere) {
    const Mesh mesh = graded();
    Spread spread(mesh, radius);
    const double fine = spread.balls(tip_at({-0.045, 0.0, 0.0})).radius, coarse = spread.balls(tip_at({0.045, 0.0, 0.0})).radius;
    std::printf("radius of a ball: %.1f mm where cells are short, %.1f mm where they are long\n", 1e3 * fine, 1e3 * coarse);
    EXPECT_LT(fine, 0.8 * coarse);
    const Mesh even = cubes();
    EXPECT_NEAR(Spread(even, radius).balls(tip_at({0.0, 0.0, -0.02})).radius, 2.0 * edge, rounding);
    constexpr double thick = 40e-3;    // [m] a needle beside which the cubes are small
    EXPECT_NEAR(Spread(even, thick).balls(tip_at({0.0, 0.0, -0.02})).radius, 1.6 * thick, rounding);
}

TEST(Spread, TakesContactsBesideTheMeshAsOnIt) {
    const Mesh mesh = cubes();
    Spread spread(mesh, radius);
    const auto on = spread.of(tip_at({0.05, 0.01, 0.0}));
    const std::vector<NodeWeight> expected(on.begin(), on.end());
    const auto beside = spread.of(tip_at({0.5, 0.01, 0.3}));
    ASSERT_EQ(beside.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
        EXPECT_EQ(beside[i].node, expected[i].node);
        EXPECT_EQ(beside[i].weight, expected[i].weight);
    }
    EXPECT_TRUE(spread.of(tip_at(Vector3::Constant(std::numeric_limits<double>::quiet_NaN()))).empty());
    EXPECT_TRUE(spread.of(shaft(Vector3::Zero(), Vector3::Constant(std::numeric_limits<double>::infinity()))).empty());
}

}    // namespace
}    // namespace stylet::corotational_fem
