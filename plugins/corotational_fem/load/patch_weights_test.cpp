// A uniform traction on a patch: the same for every mesh.
#include "load/patch_weights.h"

#include "mesh/gmsh_file.h"
#include "mesh/meshes_for_tests.h"
#include "solid/test_solids.h"

#include <gtest/gtest.h>

#include <cstdio>

namespace stylet::corotational_fem {
namespace {

using namespace testing;

constexpr double rounding = 1e-12;    // of the patch's size: hundreds of additions

std::vector<BoundaryFace> boundary_of(const Mesh& mesh) {
    return boundary_of(mesh, neighbours_of(mesh));
}

Vector3 centroid_of(const std::vector<NodeWeight>& weights, const Mesh& mesh) {
    Vector3 sum = Vector3::Zero();
    for (const NodeWeight& each : weights) sum += each.weight * mesh.nodes[each.node];
    return sum;
}

double sum_of(const std::vector<NodeWeight>& weights) {
    double sum = 0.0;
    for (const NodeWeight& each : weights) sum += each.weight;
    return sum;
}

/// Moves the nodes of the top, but those on its edges, by up to `distance` [m] along it.
Mesh with_uneven_top(Mesh mesh, double distance, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> by(-distance, distance);
    Vector3 least = mesh.nodes.front(), greatest = least;
    for (const Vector3& x : mesh.nodes) {
        least = least.cwiseMin(x);
        greatest = greatest.cwiseMax(x);
    }
    for (Vector3& x : mesh.nodes) {
        const bool on_edge = (x - least).head<2>().minCoeff() < 1e-9 || (greatest - x).head<2>().minCoeff() < 1e-9;
        if (x.z() > -1e-9 && !on_edge) x += Vector3(by(random), by(random), 0.0);
    }
    return mesh;
}

std::vector<Mesh> meshes_of_a_block() {
    const Vector3 extent(0.1, 0.1, 0.05);
    return {block(extent, {6, 6, 5}), block(extent, {11, 11, 7}), block(extent, {15, 15, 10}),
            with_uneven_top(block(extent, {11, 11, 7}), 2e-3, 1)};
}

TEST(PatchWeights, OfAnAreaHaveItsForceAndItsMomentsInEveryMesh) {
    const Patch patches[] = {{.centre = {0.0, 0.0, 0.0}, .size = {0.021, 0.021, 0.0}},
                             {.centre = {0.0123, -0.0271, 0.0}, .size = {0.0307, 0.0049, 0.0}},
                             {.centre = {0.0, 0.0, 0.0}, .size = {0.1, 0.1, 0.0}},
                             {.centre = {0.0101, 0.0207, 0.0}, .size = {1e-3, 1e-3, 0.02}}};
    double off = 0.0, off_by_nodes = 0.0;
    for (const Patch& patch : patches) {
        for (const Mesh& mesh : meshes_of_a_block()) {
            const auto weights = weights_by_area(patch, mesh, boundary_of(mesh));
            EXPECT_NEAR(sum_of(weights), 1.0, rounding);
            off = std::max(off, (centroid_of(weights, mesh) - patch.centre).norm() / patch.size.x());
            const auto nodes = weights_by_nodes(patch, mesh, boundary_of(mesh));
            if (!nodes.empty()) off_by_nodes = std::max(off_by_nodes, (centroid_of(nodes, mesh) - patch.centre).norm());
        }
    }
    std::printf("centre of the load off by %.1e of the patch; shared by nodes by up to %.2f mm\n", off, 1e3 * off_by_nodes);
    EXPECT_LE(off, rounding);
    EXPECT_GT(off_by_nodes, 1e-3) << "the meshes are too kind to tell the two apart";
}

TEST(PatchWeights, OfAnAreaTakeTheSurfaceOfAMeshFromAFile) {
    const TissueSetup tissue = skin_and_muscle();
    const Mesh mesh = read_gmsh_file(STYLET_TEST_MESHES "/two_layers_41.msh", 1e-3, tissue, "").mesh;
    const Patch patch{.centre = {0.0032, -0.0041, 0.0}, .size = {0.0113, 0.0087, 0.0}};
    const auto weights = weights_by_area(patch, mesh, boundary_of(mesh));
    EXPECT_NEAR(sum_of(weights), 1.0, rounding);
    EXPECT_LE((centroid_of(weights, mesh) - patch.centre).norm(), rounding * patch.size.x());
    for (const NodeWeight& each : weights) EXPECT_NEAR(mesh.nodes[each.node].z(), 0.0, 1e-9);
}

TEST(PatchWeights, OfAPlaneTakeNoneOfTheSidesThatMeetItsEdges) {
    const Mesh mesh = block({0.1, 0.1, 0.05}, {6, 6, 5});
    const auto weights = weights_by_area({.centre = Vector3::Zero(), .size = {0.1, 0.1, 0.0}}, mesh, boundary_of(mesh));
    for (const NodeWeight& each : weights) EXPECT_EQ(mesh.nodes[each.node].z(), 0.0);
    EXPECT_EQ(weights.size(), 49u);
}

// A top that is folded along y: its faces are known, whatever the cells along y.
TEST(PatchWeights, OfABoxOverACurvedSurfaceHaveTheForceOfItsFaces) {
    const auto height = [](double x) { return 4.0 * x * x; };          // [m] of the nodes
    constexpr double cell = 0.01, half_x = 0.0263, half_y = 0.0171;    // [m]
    double area = 0.0, moment = 0.0;                                   // [m²], [m³] of the faces' heights
    for (double x = 0.0; x < half_x; x += cell) {                      // one half of it, per length along y
        const double end = std::min(half_x, x + cell), slope = (height(x + cell) - height(x)) / cell;
        const double length = (end - x) * std::hypot(1.0, slope);
        area += length;
        moment += length * (height(x) + 0.5 * slope * (end - x));
    }
    for (const int along : {3, 8, 13}) {
        Mesh mesh = block({0.1, 0.1, 0.05}, {10, along, 5});
        for (Vector3& x : mesh.nodes) x.z() += height(x.x()) * (x.z() + 0.05) / 0.05;
        const Patch patch{.centre = {0.0, 0.005, 0.0}, .size = {2.0 * half_x, 2.0 * half_y, 0.02}};
        const auto weights = weights_by_area(patch, mesh, boundary_of(mesh));
        EXPECT_LE((centroid_of(weights, mesh) - Vector3(0.0, 0.005, moment / area)).norm(), rounding) << along;
    }
}

TEST(PatchWeights, AreNoneWhereTheBoxHoldsNone) {
    const Mesh mesh = block({0.1, 0.1, 0.05}, {6, 6, 5});
    const auto boundary = boundary_of(mesh);
    const Patch beside{.centre = {0.07, 0.0, 0.0}, .size = {0.021, 0.021, 0.0}};
    const Patch above{.centre = {0.0, 0.0, 0.001}, .size = {0.021, 0.021, 0.0}};
    const Patch inside{.centre = {0.0, 0.0, -0.02}, .size = {0.021, 0.021, 0.01}};
    const Patch line{.centre = {0.0, 0.0, 0.0}, .size = {0.021, 0.0, 0.0}};
    const Patch edge{.centre = {0.06, 0.0, 0.0}, .size = {0.02, 0.02, 0.0}};
    for (const Patch& patch : {beside, above, inside, line, edge}) EXPECT_TRUE(weights_by_area(patch, mesh, boundary).empty());
    for (const Patch& patch : {beside, above, inside}) EXPECT_TRUE(weights_by_nodes(patch, mesh, boundary).empty());
}

// A patch test of the load: a bar on a smooth floor, free at its sides.
TEST(PatchWeights, OfAWholeTopStrainABarEvenlyInAnyMesh) {
    constexpr double modulus = 25e3, pressure = 100.0, height = 0.1;    // [Pa], [Pa], [m]
    constexpr double solved = 1e-9;                                     // of the displacement: two factorisations' rounding
    for (const double poisson_ratio : {0.0, 0.3, 0.49}) {
        for (const bool shared : {false, true}) {
            const Mesh mesh = with_uneven_top(jiggled(block({0.04, 0.04, height}, {4, 4, 6}), 2e-3, 7), 3e-3, 8);
            Supported bar(mesh, elastic(modulus, poisson_ratio), shared);
            for (int i = 0; i < mesh.node_count(); ++i) {
                const Vector3& x = mesh.nodes[i];
                if (x.z() < -height + 1e-9) bar.hold(3 * i + 2, 0.0);
                if (x.z() < -height + 1e-9 && x.head<2>().norm() < 1e-9) bar.hold(i, Vector3::Zero());
                if (x.z() < -height + 1e-9 && std::abs(x.y()) < 1e-9) bar.hold(3 * i + 1, 0.0);
            }
            const Patch top{.centre = Vector3::Zero(), .size = {0.04, 0.04, 0.0}};
            const auto off = [&](const std::vector<NodeWeight>& weights) {
                VectorX forces = VectorX::Zero(3 * mesh.node_count());
                for (const NodeWeight& each : weights) forces[3 * each.node + 2] -= each.weight * pressure * 0.04 * 0.04;
                const VectorX u = bar.linear(forces);
                double worst = 0.0;
                for (int i = 0; i < mesh.node_count(); ++i) {
                    const double exact = -pressure / modulus * (mesh.nodes[i].z() + height);
                    worst = std::max(worst, std::abs(u[3 * i + 2] - exact) / (pressure / modulus * height));
                }
                return worst;
            };
            const double by_area = off(weights_by_area(top, mesh, boundary_of(mesh)));
            const double by_nodes = off(weights_by_nodes(top, mesh, boundary_of(mesh)));
            std::printf("bar, nu %.2f, %s: strain off by %.1e of p/E, shared by nodes by %.2f\n", poisson_ratio,
                        testing::pressure(shared), by_area, by_nodes);
            EXPECT_LE(by_area, solved);
            EXPECT_GT(by_nodes, 0.01) << "the mesh is too even to tell the two apart";
        }
    }
}

}    // namespace
}    // namespace stylet::corotational_fem
