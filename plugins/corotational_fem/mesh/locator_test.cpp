#include "mesh/locator.h"

#include "mesh/block_mesh.h"
#include "mesh/gmsh_file.h"
#include "mesh/meshes_for_tests.h"

#include <stylet/contract/allocations.h>

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <iostream>

namespace stylet::corotational_fem {
namespace {

constexpr double rounding = 1e-15;      // [m] of coordinates of centimetres
constexpr double on_surface = 1e-9;     // [m] what still counts as on the surface, and in
constexpr double of_way = 1e-12;        // of a way: rounding
constexpr double of_weights = 1e-12;    // of one: rounding

Mesh l_shape() {
    return read_gmsh_file(STYLET_TEST_MESHES "/l_shape.msh", 1.0, tissue_of(Vector3(0.04, 0.02, 0.04), {{"gel", 0.04}}), "").mesh;
}

Mesh two_layers() {
    return read_gmsh_file(STYLET_TEST_MESHES "/two_layers_41.msh", 1e-3, skin_and_muscle(), "").mesh;
}

Vector3 at(const Mesh& mesh, const MeshPlace& place) {
    Vector3 sum = Vector3::Zero();
    for (int i = 0; i < 4; ++i) sum += place.weights[i] * mesh.nodes[mesh.tetrahedra[place.tetrahedron][i]];
    return sum;
}

/// Points of a box, its corners, edges and faces among them.
std::vector<Vector3> lattice(const Vector3& least, const Vector3& greatest, int count) {
    std::vector<Vector3> points;
    for (int i = 0; i <= count; ++i) {
        for (int j = 0; j <= count; ++j) {
            for (int k = 0; k <= count; ++k) {
                points.push_back(least + (greatest - least).cwiseProduct(Vector3(i, j, k)) / count);
            }
        }
    }
    return points;
}

void expect_found(const Mesh& mesh, const Locator& locator, const Vector3& point) {
    const MeshPlace place = locator.find(point);
    ASSERT_NE(place.tetrahedron, no_tetrahedron) << point.transpose();
    EXPECT_LE((at(mesh, place) - point).norm(), rounding);
    EXPECT_NEAR(place.weights[0] + place.weights[1] + place.weights[2] + place.weights[3], 1.0, of_weights);
    for (const double weight : place.weights) EXPECT_GE(weight, -of_weights);
}

TEST(Locator, FindsEveryPointOfABlock) {
    const Mesh mesh = block_mesh(skin_and_muscle(), {5, 4, 6});
    const Locator locator(mesh);
    for (const Vector3& point : lattice(Vector3(-0.02, -0.015, -0.024), Vector3(0.02, 0.015, 0.0), 24)) {
        expect_found(mesh, locator, point);
    }
    for (const Vector3& node : mesh.nodes) expect_found(mesh, locator, node);
}

TEST(Locator, FindsEveryPointOfAnyMesh) {
    const Mesh mesh = two_layers();
    const Locator locator(mesh);
    for (const Vector3& point : lattice(Vector3(-0.02, -0.015, -0.024), Vector3(0.02, 0.015, 0.0), 24)) {
        expect_found(mesh, locator, point);
        EXPECT_EQ(mesh.layers[locator.find(point).tetrahedron], point.z() > -0.008 ? 0 : 1) << point.transpose();
    }
    for (const Vector3& node : mesh.nodes) expect_found(mesh, locator, node);
}

TEST(Locator, KnowsWhatIsOutside) {
    const Mesh mesh = l_shape();
    const Locator locator(mesh);
    for (const Vector3& point : lattice(Vector3(-0.025, -0.012, -0.045), Vector3(0.025, 0.012, 0.005), 25)) {
        const bool in_block =
            std::abs(point.x()) <= 0.02 && std::abs(point.y()) <= 0.01 && point.z() <= 0.0 && point.z() >= -0.04;
        const bool in_notch = point.x() > on_surface && point.z() > -0.02 + on_surface;
        EXPECT_EQ(locator.find(point).tetrahedron != no_tetrahedron, in_block && !in_notch) << point.transpose();
    }
    for (const double wrong : {std::nan(""), HUGE_VAL, -HUGE_VAL, 1e300}) {
        EXPECT_EQ(locator.find(Vector3(0.0, 0.0, wrong)).tetrahedron, no_tetrahedron);
        EXPECT_EQ(locator.find(Vector3(wrong, 0.0, -0.03)).tetrahedron, no_tetrahedron);
    }
}

TEST(Locator, APointANanometreAboveTheSurfaceIsInside) {
    const Mesh mesh = block_mesh(gel(), {5, 5, 4});
    const Locator locator(mesh);
    for (const Vector3& point : lattice(Vector3(-0.05, -0.04, 0.0), Vector3(0.05, 0.04, 0.0), 20)) {
        EXPECT_NE(locator.find(point + Vector3(0.0, 0.0, 0.9 * on_surface)).tetrahedron, no_tetrahedron);
        EXPECT_EQ(locator.find(point + Vector3(0.0, 0.0, 1.1 * on_surface)).tetrahedron, no_tetrahedron);
    }
}

/// Straight below nodes, edges and the middles of faces of the interface.
void expect_exact_borders(const Mesh& mesh, const std::vector<double>& depths) {
    const Locator locator(mesh);
    const auto layer_at = [&](double x, double y, double z) { return mesh.layers[locator.find(Vector3(x, y, z)).tetrahedron]; };
    int below = 0;
    for (const double depth : depths) {
        ++below;
        for (const Vector3& point : lattice(Vector3(-0.02, -0.015, 0.0), Vector3(0.02, 0.015, 0.0), 24)) {
            const double x = point.x(), y = point.y();
            ASSERT_EQ(layer_at(x, y, std::nextafter(-depth, 0.0)), below - 1) << point.transpose();
            ASSERT_EQ(layer_at(x, y, -depth), below) << "an interface belongs to the layer below it";
            ASSERT_EQ(layer_at(x, y, std::nextafter(-depth, -1.0)), below) << point.transpose();
        }
    }
}

TEST(Locator, KnowsTheBordersOfLayersToTheLastBit) {
    const TissueSetup tissue = tissue_of(Vector3(0.04, 0.03, 0.024), {{"skin", 0.0013}, {"fat", 0.0071}, {"muscle", 0.0156}});
    expect_exact_borders(block_mesh(tissue, {6, 5, 7}), {0.0013, 0.0013 + 0.0071});
    expect_exact_borders(block_mesh(tissue, {7, 6, 3}), {0.0013, 0.0013 + 0.0071});
    expect_exact_borders(two_layers(), {0.008});
}

/// Tetrahedra of these nodes, four each.
Mesh of_tetrahedra(const std::vector<Vector3>& nodes) {
    Mesh mesh{.nodes = nodes, .tetrahedra = {}, .layers = {}, .fixed = {}, .patches = {}};
    for (int t = 0; 4 * t < mesh.node_count(); ++t) {
        mesh.tetrahedra.push_back({4 * t, 4 * t + 1, 4 * t + 2, 4 * t + 3});
        mesh.layers.push_back(t);
    }
    return mesh;
}

TEST(Locator, ABorderBelongsToTheLowerCentroid) {
    Mesh mesh = of_tetrahedra({{0, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 0.1}});
    mesh.nodes.emplace_back(-1, 0, 0.2);
    mesh.tetrahedra.push_back({0, 2, 1, 4});
    for (const int right : {0, 1}) {
        mesh.layers = {right, 1 - right};
        EXPECT_EQ(Locator(mesh).find(Vector3(0.0, 0.2, 0.2)).tetrahedron, 0);
    }
}

TEST(Locator, ABorderOfTwoAsHighBelongsToTheLayerNamedLater) {
    Mesh mesh = of_tetrahedra({{0, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 0.1}});
    mesh.nodes.emplace_back(-1, 0, 0.1 + 1e-16);
    mesh.tetrahedra.push_back({0, 2, 1, 4});
    for (const int right : {0, 1}) {
        mesh.layers = {right, 1 - right};
        const Locator locator(mesh);
        EXPECT_EQ(mesh.layers[locator.find(Vector3(0.0, 0.2, 0.2)).tetrahedron], 1);
        EXPECT_EQ(locator.find(Vector3(1e-12, 0.2, 0.2)).tetrahedron, 0);
        EXPECT_EQ(locator.find(Vector3(-1e-12, 0.2, 0.2)).tetrahedron, 1);
    }
}

TEST(Locator, DoesNotDependOnTheNumbering) {
    const Mesh mesh = two_layers();
    const Locator locator(mesh);
    const Renumbered other = renumbered(mesh, 3);
    const Locator again(other.mesh);
    for (const Vector3& point : lattice(Vector3(-0.0201, -0.0151, -0.0241), Vector3(0.0199, 0.0149, 0.0001), 17)) {
        const MeshPlace a = locator.find(point), b = again.find(point);
        EXPECT_EQ(a.tetrahedron, b.tetrahedron == no_tetrahedron ? no_tetrahedron : other.old_tetrahedron[b.tetrahedron]);
        const Vector3 ahead(0.001, 0.002, -0.03);
        EXPECT_NEAR(locator.entry(point, point + ahead), again.entry(point, point + ahead), of_way);
    }
}

TEST(Locator, FindsWhereAWayEnters) {
    const Mesh mesh = block_mesh(gel(), {8, 6, 5});
    const Locator locator(mesh);
    const Vector3 above(0.0, 0.0, 1e-3);
    EXPECT_NEAR(locator.entry(above, Vector3(0.0, 0.0, -1e-3)), 0.5, of_way);
    EXPECT_NEAR(locator.entry(above, Vector3(1e-3, 0.0, -3e-3)), 0.25, of_way);
    EXPECT_NEAR(locator.entry(above, Vector3(0.0, 0.0, -1.0)), 1e-3 / 1.001, of_way) << "through the block and out";
    EXPECT_NEAR(locator.entry(Vector3(0.1, 0.0, -0.02), Vector3(-0.1, 0.0, -0.02)), 0.25, of_way) << "from the side";
    EXPECT_NEAR(locator.entry(Vector3(0.0, 0.0, -0.1), Vector3(0.0, 0.0, 0.1)), 0.25, of_way) << "from below";
    EXPECT_EQ(locator.entry(above, Vector3(2e-3, 0.0, 1e-6)), -1.0);
    EXPECT_EQ(locator.entry(above, above), -1.0);
    EXPECT_EQ(locator.entry(Vector3(0.06, 0.0, 0.01), Vector3(0.06, 0.0, -0.1)), -1.0) << "past the side";
}

TEST(Locator, AWayOnlyEntersInwards) {
    const Mesh mesh = block_mesh(gel(), {8, 6, 5});
    const Locator locator(mesh);
    EXPECT_EQ(locator.entry(Vector3(0.0, 0.0, -0.001), Vector3(0.0, 0.0, -0.0015)), -1.0) << "it is inside already";
    EXPECT_EQ(locator.entry(Vector3(0.0, 0.0, -0.01), Vector3(0.0, 0.0, 0.01)), -1.0) << "it leaves";
    EXPECT_EQ(locator.entry(Vector3::Zero(), Vector3(0.0, 0.0, -0.01)), 0.0) << "it begins on the surface";
    EXPECT_EQ(locator.entry(Vector3(0.0, 0.0, 0.01), Vector3::Zero()), 1.0) << "it ends on the surface";
    EXPECT_EQ(locator.entry(Vector3::Zero(), Vector3(0.01, 0.0, 0.0)), -1.0) << "it stays on the surface";
    EXPECT_EQ(locator.entry(Vector3::Zero(), Vector3(0.0, 0.0, 0.01)), -1.0);
    EXPECT_EQ(locator.entry(Vector3(0.0, 0.0, 0.01), Vector3(0.0, 0.0, 1e-300)), -1.0) << "it ends above it";
    for (const double wrong : {std::nan(""), HUGE_VAL, 1.7e308}) {
        EXPECT_EQ(locator.entry(Vector3(0.0, 0.0, -wrong), Vector3(0.0, 0.0, wrong)), -1.0);
    }
}

TEST(Locator, FindsTheFirstOfSeveralSurfaces) {
    const Mesh mesh = l_shape();
    const Locator locator(mesh);
    EXPECT_NEAR(locator.entry(Vector3(0.01, 0.0, 0.01), Vector3(0.01, 0.0, -0.05)), 0.5, of_way) << "the step at 20 mm";
    EXPECT_NEAR(locator.entry(Vector3(-0.01, 0.0, 0.01), Vector3(-0.01, 0.0, -0.05)), 1.0 / 6.0, of_way);
    EXPECT_NEAR(locator.entry(Vector3(-0.04, 0.0, -0.01), Vector3(0.04, 0.0, -0.01)), 0.25, of_way);
    EXPECT_NEAR(locator.entry(Vector3(0.02, 0.0, -0.01), Vector3(-0.02, 0.0, -0.01)), 0.5, of_way) << "from the notch";
    EXPECT_NEAR(locator.entry(Vector3(-0.01, 0.0, -0.01), Vector3(0.03, 0.0, -0.03)), 0.5, of_way)
        << "out into the notch, and in again";
}

TEST(Locator, OfTwoSurfacesInOneBucketTheFirstCounts) {
    const std::vector<Vector3> upper = {{0, 0, 0.2}, {1, 0, 0.2}, {0, 1, 0.2}, {0, 0, 0.3}};
    const std::vector<Vector3> lower = {{0, 0, 0.0}, {1, 0, 0.0}, {0, 1, 0.0}, {0, 0, 0.1}};
    for (const bool upper_first : {true, false}) {
        std::vector<Vector3> nodes = upper_first ? upper : lower;
        nodes.insert(nodes.end(), (upper_first ? lower : upper).begin(), (upper_first ? lower : upper).end());
        const Mesh mesh = of_tetrahedra(nodes);
        const Locator locator(mesh);
        EXPECT_NEAR(locator.entry(Vector3(0.2, 0.2, 1.26), Vector3(0.2, 0.2, -0.74)), 0.5, of_way);
        EXPECT_NEAR(locator.entry(Vector3(0.2, 0.2, -1.0), Vector3(0.2, 0.2, 1.0)), 0.5, of_way);
    }
}

/// A way has to meet the surface wherever it goes: at nodes and along edges too.
TEST(Locator, TheSurfaceHasNoHoles) {
    const Mesh mesh = two_layers();
    const Locator locator(mesh);
    for (const Vector3& point : lattice(Vector3(-0.02, -0.015, -0.024), Vector3(0.02, 0.015, 0.0), 24)) {
        const Vector3 way(0.0, 0.0, -0.1);
        EXPECT_NEAR(locator.entry(point - way, point + way), (0.1 + point.z()) / 0.2, of_way) << point.transpose();
    }
    for (const Vector3& node : mesh.nodes) {
        const Vector3 centre(0.0, 0.0, -0.012), outside = centre + 3.0 * (node - centre);
        const double entry = locator.entry(outside, centre);
        const Vector3 there = outside + entry * (centre - outside);
        const Vector3 off = (there - centre).cwiseAbs() - Vector3(0.02, 0.015, 0.012);
        EXPECT_LE(std::abs(off.maxCoeff()), rounding) << node.transpose();
    }
}

TEST(Locator, ItsBoundaryIsClosedAndFacesOutwards) {
    for (const Mesh& mesh : {block_mesh(gel(), {4, 3, 5}), l_shape()}) {
        const Locator locator(mesh);
        double volume = 0.0;    // [m³]
        Vector3 area = Vector3::Zero();
        for (const BoundaryFace& face : locator.boundary()) {
            const Vector3 &a = mesh.nodes[face.nodes[0]], &b = mesh.nodes[face.nodes[1]], &c = mesh.nodes[face.nodes[2]];
            area += 0.5 * (b - a).cross(c - a);
            volume += a.dot(b.cross(c)) / 6.0;
            const Tetrahedron& nodes = mesh.tetrahedra[face.tetrahedron];
            for (const int node : face.nodes) EXPECT_NE(std::find(nodes.begin(), nodes.end(), node), nodes.end());
        }
        EXPECT_LE(area.norm(), rounding);
        const double filled = volume_of_layer(mesh, 0);
        EXPECT_NEAR(volume, filled, 1e-12 * filled);
    }
}

TEST(Locator, AllocatesNothingToAnswer) {
    const Mesh mesh = two_layers();
    const Locator locator(mesh);
    const std::size_t before = contract::allocations();
    const Vector3 above(0.0, 0.0, 1e-3), inside(0.001, 0.002, -0.02);
    const MeshPlace place = locator.find(inside);
    const double fraction = locator.entry(above, inside);
    EXPECT_EQ(contract::allocations(), before);
    EXPECT_TRUE(place.tetrahedron != no_tetrahedron && fraction > 0.0);
}

TEST(Locator, AnswersForALargeMesh) {
    const TissueSetup tissue = tissue_of(Vector3(0.1, 0.1, 0.05), {{"gel", 0.05}});
    const Mesh mesh = block_mesh(tissue, {23, 23, 16});
    const auto clock = [] { return std::chrono::steady_clock::now(); };
    const auto microseconds = [](auto time) { return std::chrono::duration<double, std::micro>(time).count(); };
    const auto begin = clock();
    const Locator locator(mesh);
    const auto built = clock();
    const std::vector<Vector3> points = lattice(Vector3(-0.05, -0.05, -0.05), Vector3(0.05, 0.05, 0.0), 30);
    int found = 0;
    for (const Vector3& point : points) found += locator.find(point).tetrahedron != no_tetrahedron ? 1 : 0;
    const auto located = clock();
    int entered = 0;
    for (const Vector3& point : points) entered += locator.entry(point + Vector3(0.0, 0.0, 0.06), point) >= 0.0 ? 1 : 0;
    const auto done = clock();
    EXPECT_EQ(found, static_cast<int>(points.size()));
    EXPECT_EQ(entered, static_cast<int>(points.size()));
    const auto count = static_cast<double>(points.size());
    std::cout << mesh.size() << " tetrahedra: built in " << microseconds(built - begin) / 1e3 << " ms, a point in "
              << microseconds(located - built) / count << " us, a way of 60 mm in " << microseconds(done - located) / count
              << " us\n";
}

}    // namespace
}    // namespace stylet::corotational_fem
