#include "mesh/patches.h"

#include "mesh/block_mesh.h"
#include "mesh/faces.h"
#include "mesh/gmsh_file.h"
#include "mesh/meshes_for_tests.h"

#include <gtest/gtest.h>

#include <iostream>
#include <map>
#include <set>

namespace stylet::corotational_fem {
namespace {

using Patches = std::map<int, std::vector<int>>;    // tetrahedra by patch

Patches by_patch(const std::vector<int>& patch) {
    Patches patches;
    for (std::size_t t = 0; t < patch.size(); ++t) patches[patch[t]].push_back(static_cast<int>(t));
    return patches;
}

Mesh two_layers() {
    return read_gmsh_file(STYLET_TEST_MESHES "/two_layers_41.msh", 1e-3, skin_and_muscle(), "").mesh;
}

Mesh ball_in_a_block() {
    const TissueSetup tissue = tissue_of(Vector3(0.03, 0.03, 0.03), {{"gel", 0.02}, {"tumour", 0.01}});
    return read_gmsh_file(STYLET_TEST_MESHES "/inclusion.msh", 1e-3, tissue, "").mesh;
}

bool connected(const Mesh& mesh, const std::vector<int>& tetrahedra) {
    const auto neighbours = neighbours_of(mesh);
    const std::set<int> all(tetrahedra.begin(), tetrahedra.end());
    std::vector<int> found = {tetrahedra.front()};
    std::set<int> seen(found.begin(), found.end());
    for (std::size_t i = 0; i < found.size(); ++i) {
        for (const int other : neighbours[found[i]]) {
            if (all.contains(other) && seen.insert(other).second) found.push_back(other);
        }
    }
    return found.size() == all.size();
}

void expect_sound(const Mesh& mesh) {
    const std::vector<int> patch = patches_of(mesh);
    ASSERT_EQ(patch.size(), mesh.tetrahedra.size());
    const Patches patches = by_patch(patch);
    EXPECT_EQ(patches.begin()->first, 0);
    EXPECT_EQ(patches.rbegin()->first + 1, static_cast<int>(patches.size())) << "numbered without gaps";
    for (const auto& [number, tetrahedra] : patches) {
        EXPECT_TRUE(connected(mesh, tetrahedra)) << "patch " << number;
        for (const int t : tetrahedra) EXPECT_EQ(mesh.layers[t], mesh.layers[tetrahedra.front()]);
    }
}

TEST(Patches, AreConnectedAndOfOneLayer) {
    expect_sound(two_layers());
    expect_sound(ball_in_a_block());
    expect_sound(block_mesh(skin_and_muscle(), {5, 5, 7}));
}

TEST(Patches, MostHaveSixToFourteenTetrahedra) {
    for (const Mesh& mesh : {two_layers(), ball_in_a_block(), block_mesh(gel(), {8, 8, 5})}) {
        std::size_t inside = 0, largest = 0, smallest = mesh.tetrahedra.size();
        const Patches patches = by_patch(patches_of(mesh));
        for (const auto& [number, tetrahedra] : patches) {
            inside += tetrahedra.size() >= 6 && tetrahedra.size() <= 14 ? 1 : 0;
            largest = std::max(largest, tetrahedra.size());
            smallest = std::min(smallest, tetrahedra.size());
        }
        std::cout << mesh.size() << " tetrahedra, " << mesh.node_count() << " nodes: " << patches.size() << " patches of "
                  << smallest << " to " << largest << ", " << inside << " of them of 6 to 14\n";
        EXPECT_GE(static_cast<double>(inside), 0.8 * static_cast<double>(patches.size()));
        EXPECT_GE(smallest, 6U);
        EXPECT_LE(largest, 24U) << "a patch as large as the surroundings of a node would hardly share anything out";
    }
}

TEST(Patches, ATetrahedronAloneInItsLayerIsItsOwn) {
    Mesh mesh = block_mesh(gel(), {2, 2, 2});
    mesh.layers[17] = 1;
    const Patches patches = by_patch(patches_of(mesh));
    EXPECT_EQ(
        std::count_if(patches.begin(), patches.end(), [](const auto& patch) { return patch.second == std::vector<int>{17}; }), 1);
    expect_sound(mesh);
}

TEST(Patches, DoNotDependOnTheNumbering) {
    const Mesh mesh = ball_in_a_block();
    const std::vector<int> patch = patches_of(mesh);
    const Renumbered other = renumbered(mesh, 7);
    const std::vector<int> again = patches_of(other.mesh);
    for (std::size_t t = 0; t < again.size(); ++t) ASSERT_EQ(again[t], patch[other.old_tetrahedron[t]]);
}

}    // namespace
}    // namespace stylet::corotational_fem
