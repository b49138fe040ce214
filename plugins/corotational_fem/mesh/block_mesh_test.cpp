#include "mesh/block_mesh.h"

#include "mesh/faces.h"
#include "mesh/meshes_for_tests.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace stylet::corotational_fem {
namespace {

constexpr double rounding = 1e-15;    // [m] of coordinates of centimetres

std::set<double> planes_of(const Mesh& mesh) {
    std::set<double> planes;
    for (const Vector3& node : mesh.nodes) planes.insert(node.z());
    return planes;
}

TEST(BlockMesh, FillsTheBlockWithRightHandedTetrahedraOfEqualVolume) {
    const Mesh mesh = block_mesh(gel(), {3, 4, 5});
    ASSERT_EQ(mesh.size(), 6 * 3 * 4 * 5);
    EXPECT_EQ(mesh.node_count(), 4 * 5 * 6);
    constexpr double whole = 0.1 * 0.08 * 0.05, same = 1e-12;    // [m³]; relative, of rounding
    for (const Tetrahedron& nodes : mesh.tetrahedra) EXPECT_NEAR(volume_of(mesh, nodes), whole / 360.0, same * whole / 360.0);
    const auto [least, greatest] = std::minmax_element(mesh.nodes.begin(), mesh.nodes.end(),
                                                       [](const Vector3& a, const Vector3& b) { return a.sum() < b.sum(); });
    EXPECT_EQ(*least, Vector3(-0.05, -0.04, -0.05));
    EXPECT_EQ(*greatest, Vector3(0.05, 0.04, 0.0));
}

TEST(BlockMesh, HasTheSizeOfTheStatedWorkload) {
    const Mesh mesh = block_mesh(tissue_of(Vector3(0.1, 0.1, 0.05), {{"gel", 0.05}}), {15, 15, 10});
    EXPECT_EQ(mesh.size(), 13500);
    EXPECT_EQ(mesh.node_count(), 2816);
}

TEST(BlockMesh, CellsMeetFaceToFace) {
    const Mesh mesh = block_mesh(gel(), {3, 4, 2});
    std::size_t inside = 0, boundary = 0;
    std::vector<FaceUse> sorted = sorted_faces(mesh);
    for (std::span<const FaceUse> faces = sorted; !faces.empty();) {
        const std::size_t uses = uses_of_first(faces);
        ASSERT_LE(uses, 2U);
        ++(uses == 2 ? inside : boundary);
        faces = faces.subspan(uses);
    }
    EXPECT_EQ(boundary, 2U * 2U * (3U * 4U + 4U * 2U + 3U * 2U)) << "two triangles for each square";
    EXPECT_EQ(2 * inside + boundary, 4U * mesh.tetrahedra.size());
}

TEST(BlockMesh, EveryTetrahedronRunsAlongItsCellsDiagonal) {
    const Mesh mesh = block_mesh(gel(), {5, 4, 5});
    const Vector3 cell(0.02, 0.02, 0.01);
    for (const Tetrahedron& nodes : mesh.tetrahedra) {
        Vector3 least = mesh.nodes[nodes[0]], greatest = least;
        for (const int node : nodes) {
            least = least.cwiseMin(mesh.nodes[node]);
            greatest = greatest.cwiseMax(mesh.nodes[node]);
        }
        EXPECT_LE((greatest - least - cell).norm(), rounding);
        const auto has = [&](const Vector3& corner) {
            return std::any_of(nodes.begin(), nodes.end(), [&](int node) { return mesh.nodes[node] == corner; });
        };
        EXPECT_TRUE(has(least) && has(greatest));
    }
}

TEST(BlockMesh, IsTheSameOnBothSidesOfTheMiddle) {
    const Mesh mesh = block_mesh(gel(), {7, 6, 1});
    for (const Vector3& node : mesh.nodes) {
        EXPECT_TRUE(std::find(mesh.nodes.begin(), mesh.nodes.end(), Vector3(-node.x(), -node.y(), node.z())) != mesh.nodes.end());
    }
}

TEST(BlockMesh, OneLayerHasUniformPlanes) {
    const std::set<double> planes = planes_of(block_mesh(gel(), {1, 1, 10}));
    ASSERT_EQ(planes.size(), 11U);
    int k = 10;
    for (const double z : planes) EXPECT_NEAR(z, -0.005 * k--, rounding);
    EXPECT_FALSE(std::signbit(*planes.rbegin())) << "the top is at 0, not at -0";
}

TEST(BlockMesh, LayersMeetOnPlanesOfNodes) {
    const TissueSetup tissue = tissue_of(Vector3(0.1, 0.1, 0.05), {{"skin", 0.002}, {"fat", 0.0131}, {"muscle", 0.0349}});
    const Mesh mesh = block_mesh(tissue, {2, 3, 8});
    const std::set<double> planes = planes_of(mesh);
    ASSERT_EQ(planes.size(), 9U);
    for (const double border : {0.0, -0.002, -(0.002 + 0.0131), -0.05}) EXPECT_EQ(planes.count(border), 1U) << border;
    for (int layer = 0; layer < 3; ++layer) {
        const double volume = 0.1 * 0.1 * tissue.layers[layer].thickness;    // [m³]
        EXPECT_NEAR(volume_of_layer(mesh, layer), volume, 1e-12 * volume);
    }
}

TEST(BlockMesh, SharesCellsOutByThickness) {
    const auto cells_in = [](int nz, int layer) {
        const Mesh mesh =
            block_mesh(tissue_of(Vector3(0.1, 0.1, 0.05), {{"skin", 0.01}, {"fat", 0.001}, {"muscle", 0.039}}), {1, 1, nz});
        return std::count(mesh.layers.begin(), mesh.layers.end(), layer) / 6;
    };
    EXPECT_EQ(cells_in(3, 1), 1) << "at least one each";
    EXPECT_EQ(cells_in(6, 0), 1);
    EXPECT_EQ(cells_in(6, 1), 1);
    EXPECT_EQ(cells_in(6, 2), 4);
    EXPECT_EQ(cells_in(50, 0), 10);
    EXPECT_EQ(cells_in(50, 1), 1);
    EXPECT_EQ(cells_in(50, 2), 39);
}

TEST(BlockMesh, ACellIsAPatchOfOneLayer) {
    const Mesh mesh = block_mesh(skin_and_muscle(), {3, 2, 4});
    for (int t = 0; t < mesh.size(); ++t) {
        EXPECT_EQ(mesh.patches[t], t / 6);
        EXPECT_EQ(mesh.layers[t], mesh.layers[t / 6 * 6]);
    }
}

TEST(BlockMesh, HoldsWhatTheTissueSays) {
    TissueSetup tissue = gel();
    const auto wrongly_held = [&](auto should_be_held) {
        const Mesh mesh = block_mesh(tissue, {4, 3, 3});
        int wrong = 0;
        for (int n = 0; n < mesh.node_count(); ++n) wrong += (mesh.fixed[n] != 0) != should_be_held(mesh.nodes[n]) ? 1 : 0;
        return wrong;
    };
    const auto at_bottom = [](const Vector3& at) { return at.z() == -0.05; };
    const auto at_side = [](const Vector3& at) { return std::abs(at.x()) == 0.05 || std::abs(at.y()) == 0.04; };
    EXPECT_EQ(wrongly_held(at_bottom), 0);
    tissue.fixed = "sides";
    EXPECT_EQ(wrongly_held(at_side), 0);
    tissue.fixed = "bottom_and_sides";
    EXPECT_EQ(wrongly_held([&](const Vector3& at) { return at_bottom(at) || at_side(at); }), 0);
}

TEST(BlockMesh, SaysWhichCellsItWants) {
    TissueSetup tissue = skin_and_muscle();
    const auto with = [&](std::array<int, 3> cells) {
        try {
            (void)block_mesh(tissue, cells);
        } catch (const Error& error) {
            return error.key() + ": " + error.what();
        }
        return std::string("accepted");
    };
    EXPECT_EQ(with({4, 4, 1}), "cells: found 1 along z for 2 layers, wanted at least one cell through each layer");
    EXPECT_EQ(with({4, 0, 4}), "cells: found 4 x 0 x 4 cells, wanted at least one along each axis");
    EXPECT_EQ(with({4, 4, -1}), "cells: found 4 x 4 x -1 cells, wanted at least one along each axis");
    EXPECT_EQ(with({2000000000, 2000000000, 2000000000}),
              "cells: found 2000000000 x 2000000000 x 2000000000 cells, wanted at most 1000000 in all");
    EXPECT_EQ(with({400, 1, 2}),
              "cells: found cells of 0.0001 x 0.03 x 0.016 m in the layer \"muscle\", whose tetrahedra are slivers, "
              "wanted cells of more even sides");
    EXPECT_EQ(with({1, 3, 2}), "accepted");
    tissue.fixed = "sides";
    EXPECT_EQ(with({1, 3, 2}),
              "cells: found 1 x 3 x 2 cells, all of whose nodes are on the sides, which are held, wanted two at least "
              "along x and y");
}

}    // namespace
}    // namespace stylet::corotational_fem
