#include "mesh/gmsh_file.h"

#include "mesh/mesh_file_for_tests.h"
#include "mesh/meshes_for_tests.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>

namespace stylet::corotational_fem {
namespace {

constexpr double millimetre = 1e-3;         // [m]
constexpr double of_volume = 1e-12;         // relative: rounding
constexpr double digits_of_file = 1e-14;    // [m]: 16 digits of centimetres
const std::string meshes = STYLET_TEST_MESHES "/";

GmshMesh two_layers(const std::string& form, const std::string& fixed = "", const std::string& where = "bottom") {
    TissueSetup tissue = skin_and_muscle();
    tissue.fixed = where;
    return read_gmsh_file(meshes + "two_layers_" + form + ".msh", millimetre, tissue, fixed);
}

int held(const Mesh& mesh) {
    return static_cast<int>(std::count(mesh.fixed.begin(), mesh.fixed.end(), 1));
}

TEST(GmshFile, ReadsLayersFromRegions) {
    for (const std::string form : {"22", "22_binary", "41", "41_binary"}) {
        const Mesh mesh = two_layers(form).mesh;
        EXPECT_EQ(mesh.size(), 504) << form;
        EXPECT_EQ(mesh.node_count(), 166);
        const double base = 0.04 * 0.03;    // [m²]
        EXPECT_NEAR(volume_of_layer(mesh, 0), base * 0.008, of_volume * base * 0.008);
        EXPECT_NEAR(volume_of_layer(mesh, 1), base * 0.016, of_volume * base * 0.016);
        EXPECT_EQ(mesh.patches.size(), mesh.tetrahedra.size());
    }
}

TEST(GmshFile, EveryFormSaysTheSame) {
    const GmshMesh first = two_layers("41");
    for (const std::string form : {"22", "22_binary", "41_binary"}) {
        const GmshMesh other = two_layers(form);
        EXPECT_EQ(other.mesh.tetrahedra, first.mesh.tetrahedra) << form;
        EXPECT_EQ(other.mesh.layers, first.mesh.layers);
        EXPECT_EQ(other.mesh.fixed, first.mesh.fixed);
        EXPECT_EQ(other.mesh.patches, first.mesh.patches);
        EXPECT_EQ(other.tags.nodes, first.tags.nodes);
        for (int n = 0; n < first.mesh.node_count(); ++n) {
            EXPECT_LE((other.mesh.nodes[n] - first.mesh.nodes[n]).norm(), digits_of_file);
        }
        ASSERT_EQ(other.node_sets.size(), first.node_sets.size());
        for (std::size_t i = 0; i < first.node_sets.size(); ++i) {
            EXPECT_EQ(other.node_sets[i].name, first.node_sets[i].name);
            EXPECT_EQ(other.node_sets[i].nodes, first.node_sets[i].nodes);
        }
    }
}

TEST(GmshFile, NamesNodeSets) {
    const GmshMesh read = two_layers("41");
    ASSERT_EQ(read.node_sets.size(), 3U);
    EXPECT_EQ(read.node_sets[0].name, "lid");
    EXPECT_EQ(read.node_sets[0].dimension, 2);
    std::vector<int> top;
    for (int n = 0; n < read.mesh.node_count(); ++n) {
        if (std::abs(read.mesh.nodes[n].z()) <= digits_of_file) top.push_back(n);
    }
    EXPECT_EQ(read.node_sets[0].nodes, top);
}

TEST(GmshFile, HoldsThePlanesOfItsBox) {
    const auto count = [](const Mesh& mesh, auto is_held) {
        return std::count_if(mesh.nodes.begin(), mesh.nodes.end(), is_held);
    };
    const auto at_bottom = [](const Vector3& at) { return std::abs(at.z() + 0.024) <= digits_of_file; };
    const auto at_side = [](const Vector3& at) {
        return std::min(std::abs(std::abs(at.x()) - 0.02), std::abs(std::abs(at.y()) - 0.015)) <= digits_of_file;
    };
    const Mesh bottom = two_layers("41", "", "bottom").mesh;
    EXPECT_EQ(held(bottom), count(bottom, at_bottom));
    const Mesh sides = two_layers("41", "", "sides").mesh;
    EXPECT_EQ(held(sides), count(sides, at_side));
    const Mesh both = two_layers("41", "", "bottom_and_sides").mesh;
    EXPECT_EQ(held(both), count(both, [&](const Vector3& at) { return at_bottom(at) || at_side(at); }));
    EXPECT_LT(held(both), held(bottom) + held(sides));
}

TEST(GmshFile, HoldsANamedSetInstead) {
    const GmshMesh read = two_layers("22_binary", "lid");
    EXPECT_EQ(held(read.mesh), static_cast<int>(read.node_sets[0].nodes.size()));
    for (const int node : read.node_sets[0].nodes) EXPECT_EQ(read.mesh.fixed[node], 1);
    EXPECT_EQ(refusal([] { (void)two_layers("41", "led"); }), meshes +
                                                                  "two_layers_41.msh: found no physical group \"led\" to hold, "
                                                                  "wanted one of the file's: \"lid\", \"skin\", \"muscle\"");
}

TEST(GmshFile, ReadsABallInABlock) {
    const TissueSetup tissue = tissue_of(Vector3(0.03, 0.03, 0.03), {{"gel", 0.02}, {"tumour", 0.01}});
    const Mesh mesh = read_gmsh_file(meshes + "inclusion.msh", millimetre, tissue, "").mesh;
    const double block = 0.03 * 0.03 * 0.03, ball = 4.0 / 3.0 * std::numbers::pi * 0.005 * 0.005 * 0.005;    // [m³]
    EXPECT_NEAR(volume_of_layer(mesh, 0) + volume_of_layer(mesh, 1), block, of_volume * block);
    EXPECT_LE(volume_of_layer(mesh, 1), ball) << "flat faces cut a ball";
    EXPECT_GE(volume_of_layer(mesh, 1), 0.7 * ball);
}

TEST(GmshFile, OneUnnamedRegionWillDoForOneLayer) {
    const TissueSetup tissue = tissue_of(Vector3(0.04, 0.02, 0.04), {{"gel", 0.04}});
    const Mesh mesh = read_gmsh_file(meshes + "l_shape.msh", 1.0, tissue, "").mesh;
    constexpr double volume = 0.75 * 0.04 * 0.02 * 0.04;    // [m³]
    EXPECT_NEAR(volume_of_layer(mesh, 0), volume, of_volume * volume);
}

TEST(GmshFile, WantsTheTissuesBlock) {
    TissueSetup tissue = skin_and_muscle();
    const auto read = [&](double unit) {
        return refusal([&] { (void)read_gmsh_file(meshes + "two_layers_41.msh", unit, tissue, ""); });
    };
    EXPECT_EQ(read(1.0), meshes +
                             "two_layers_41.msh: found a mesh of -20 to 20 m along x, -15 to 15 m along y, -24 to 0 m along z "
                             "(a length of 1 in the file is 1 m), wanted the tissue's extent: -0.02 to 0.02 m along x, "
                             "-0.015 to 0.015 m along y, -0.024 to 0 m along z");
    tissue.extent.z() *= 1.0 + 1e-7;    // well within a file of seven digits
    EXPECT_EQ(read(millimetre), "accepted");
    tissue.extent.z() *= 1.0 + 1e-5;
    EXPECT_NE(read(millimetre), "accepted");
}

TEST(GmshFile, WantsALayerForEveryRegionAndARegionForEveryLayer) {
    const auto with = [](const std::vector<std::pair<std::string, double>>& layers) {
        return refusal([&] {
            (void)read_gmsh_file(meshes + "two_layers_22.msh", millimetre, tissue_of(Vector3(0.04, 0.03, 0.024), layers), "");
        });
    };
    const std::string file = meshes + "two_layers_22.msh";
    EXPECT_EQ(with({{"skin", 0.008}, {"fat", 0.016}}),
              file + ":8: found the region \"muscle\", wanted the name of one of the tissue's layers: \"skin\", \"fat\"");
    EXPECT_EQ(
        with({{"skin", 0.008}, {"fat", 0.004}, {"muscle", 0.012}}),
        file +
            ": found no tetrahedron of the layer \"fat\", wanted some of each layer; the file's regions: \"skin\", \"muscle\"");
    const TissueSetup two = tissue_of(Vector3(0.04, 0.02, 0.04), {{"skin", 0.01}, {"muscle", 0.03}});
    const std::string unnamed = refusal([&] { (void)read_gmsh_file(meshes + "l_shape.msh", 1.0, two, ""); });
    EXPECT_NE(
        unnamed.find("in no named region (physical volume), wanted the name of one of the tissue's layers: \"skin\", \"muscle\""),
        std::string::npos)
        << unnamed;
}

/// A cube of one metre in six tetrahedra whose tags are sparse and in no order.
TEST(GmshFile, TagsMayBeSparseAndInAnyOrder) {
    for (const std::string& text : {cube_22(), cube_41()}) {
        const MeshFile file(text);
        const GmshMesh read = read_gmsh_file(file.path(), 1.0, cube_tissue(), "");
        EXPECT_EQ(read.mesh.size(), 6);
        EXPECT_NEAR(volume_of_layer(read.mesh, 0), 1.0, of_volume);
        EXPECT_EQ(read.tags.nodes, (std::vector<std::uint64_t>{900, 7, 31, 12, 800000, 5, 6, 44}));
        EXPECT_EQ(read.tags.tetrahedra, (std::vector<std::uint64_t>{60, 50, 40, 30, 20, 10}));
    }
}

TEST(GmshFile, ChecksTheMesh) {
    const MeshFile file(replaced(cube_22(), "60 4 2 1 1 900 7 12 44", "60 4 2 1 1 7 900 12 44"));
    const std::string found = refusal([&] { (void)read_gmsh_file(file.path(), 1.0, cube_tissue(), ""); });
    EXPECT_EQ(found.find(file.path() + ": found inverted tetrahedra"), 0U) << found;
    EXPECT_NE(found.find("tetrahedron 60 (nodes 7, 900, 12, 44)"), std::string::npos) << found;
}

TEST(GmshFile, IsLocatedAtItsKey) {
    try {
        (void)read_gmsh_file(meshes + "missing.msh", 1.0, gel(), "");
        FAIL() << "accepted";
    } catch (const Error& error) {
        EXPECT_EQ(error.key(), "mesh");
        EXPECT_EQ(error.what(), meshes + "missing.msh: found no file here, wanted a Gmsh mesh (.msh)");
    }
}

}    // namespace
}    // namespace stylet::corotational_fem
