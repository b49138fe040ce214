#include "mesh/mesh_checks.h"

#include "mesh/block_mesh.h"
#include "mesh/meshes_for_tests.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace stylet::corotational_fem {
namespace {

std::string refusal_of(const Mesh& mesh, const MeshTags& tags = {}) {
    return refusal([&] { check_mesh(mesh, tags, "mesh"); });
}

/// One tetrahedron, held at three nodes.
Mesh one(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& d) {
    return {.nodes = {a, b, c, d}, .tetrahedra = {{0, 1, 2, 3}}, .layers = {0}, .fixed = {1, 1, 1, 0}, .patches = {0}};
}

/// Its base is an equilateral triangle of one metre.
Mesh pyramid(double height) {
    const double third = std::sqrt(3.0) / 6.0;
    return one({-0.5, -third, 0.0}, {0.5, -third, 0.0}, {0.0, 2.0 * third, 0.0}, {0.0, 0.0, height});
}

Mesh block() {
    return block_mesh(gel(), {3, 3, 2});
}

void expect_says(const std::string& found, const std::string& wanted) {
    EXPECT_NE(found.find(wanted), std::string::npos) << "found \"" << found << "\",\nwanted \"" << wanted << "\" in it";
}

TEST(MeshChecks, ASoundMeshPasses) {
    EXPECT_EQ(refusal_of(block()), "accepted");
    EXPECT_EQ(refusal_of(block_mesh(tissue_of(Vector3(0.1, 0.1, 0.05), {{"skin", 0.0005}, {"fat", 0.0495}}), {10, 10, 2})),
              "accepted")
        << "cells twenty times as wide as they are high";
}

TEST(MeshChecks, MeasureShapesAsTextbooksDo) {
    constexpr double rounding = 1e-12;    // relative
    const Mesh regular = pyramid(std::sqrt(2.0 / 3.0));
    EXPECT_NEAR(smallest_dihedral_angle(regular, regular.tetrahedra[0]), std::acos(1.0 / 3.0) * 180.0 / std::numbers::pi, 1e-10);
    EXPECT_NEAR(aspect_of(regular, regular.tetrahedra[0]), std::sqrt(1.5), rounding);
    const Mesh flat = pyramid(1e-6);    // its height over the base's inradius is the angle's tangent
    EXPECT_NEAR(smallest_dihedral_angle(flat, flat.tetrahedra[0]),
                std::atan(1e-6 * 2.0 * std::sqrt(3.0)) * 180.0 / std::numbers::pi, 1e-12);
    EXPECT_NEAR(aspect_of(flat, flat.tetrahedra[0]), 1e6, 1e-6);
}

/// Hard case 6.
TEST(MeshChecks, RefusesASliverOfATenthOfADegree) {
    const double height = std::tan(0.1 * std::numbers::pi / 180.0) / (2.0 * std::sqrt(3.0));
    const std::string found = refusal_of(pyramid(height));
    expect_says(
        found,
        "found slivers, wanted no angle between faces below 0.5 degrees and no longest edge over least height above 1000: "
        "tetrahedron 0 (nodes 0, 1, 2, 3)");
    expect_says(found, "m has 0.1 degrees and 1984.");
}

/// Hard case 6.
TEST(MeshChecks, RefusesANeedleOfAspectTenThousand) {
    const Mesh needle = pyramid(1e4);
    EXPECT_GT(smallest_dihedral_angle(needle, needle.tetrahedra[0]), 30.0) << "its angles are good";
    expect_says(refusal_of(needle), "degrees and 11547");
}

TEST(MeshChecks, AcceptsWhatIsJustWithinTheBounds) {
    EXPECT_EQ(refusal_of(pyramid(std::tan(0.51 * std::numbers::pi / 180.0) / (2.0 * std::sqrt(3.0)))), "accepted");
    EXPECT_EQ(refusal_of(pyramid(0.86 * 990.0)), "accepted");
}

/// Hard case 7.
TEST(MeshChecks, NamesAnInvertedTetrahedronByItsTags) {
    Mesh mesh = one(Vector3::Zero(), Vector3::UnitX(), Vector3::UnitY(), Vector3::UnitZ());
    mesh.nodes.emplace_back(1.0, 1.0, 1.0);
    mesh.fixed.push_back(0);
    mesh.tetrahedra.push_back({1, 2, 4, 3});
    expect_says(refusal_of(mesh, {.nodes = {10, 20, 30, 40, 50}, .tetrahedra = {7, 8}}),
                "found inverted tetrahedra, wanted nodes in right-handed order: "
                "tetrahedron 8 (nodes 20, 30, 50, 40) at (0.5, 0.5, 0.5) m has a volume of -0.333333 m^3");
}

TEST(MeshChecks, KnowsAMirroredMesh) {
    Mesh mesh = block();
    for (Vector3& node : mesh.nodes) node.x() = -node.x();
    expect_says(refusal_of(mesh), "found a mesh that is left-handed throughout");
}

TEST(MeshChecks, RefusesAFlatTetrahedron) {
    expect_says(refusal_of(pyramid(0.0)), "found flat tetrahedra, wanted some volume in each: tetrahedron 0");
    expect_says(refusal_of(pyramid(1e-14)), "found flat tetrahedra");
    expect_says(refusal_of(one(Vector3::Zero(), Vector3::Zero(), Vector3::Zero(), Vector3::Zero())), "found flat tetrahedra");
}

/// Hard case 7.
TEST(MeshChecks, RefusesADuplicate) {
    Mesh mesh = block();
    const auto [a, b, c, d] = mesh.tetrahedra[5];
    mesh.tetrahedra.push_back({b, c, a, d});
    mesh.layers.push_back(0);
    const std::string found = refusal_of(mesh);
    expect_says(found, "found duplicate tetrahedra, wanted each once: tetrahedron 108 (nodes");
    expect_says(found, "is number 5 again");
    EXPECT_EQ(found.find("overlap"), std::string::npos) << "said once";
}

TEST(MeshChecks, RefusesTetrahedraThatOverlap) {
    Mesh mesh = one(Vector3::Zero(), Vector3::UnitX(), Vector3::UnitY(), Vector3::UnitZ());
    mesh.nodes.emplace_back(0.2, 0.2, 0.5);
    mesh.fixed.push_back(0);
    mesh.tetrahedra.push_back({0, 1, 2, 4});
    expect_says(refusal_of(mesh), "found tetrahedra that overlap, wanted each on its own side of a common face: tetrahedron 1");
}

/// Hard case 34.
TEST(MeshChecks, RefusesANodeWithoutMass) {
    Mesh mesh = block();
    mesh.nodes.emplace_back(0.01, 0.0, -0.02);
    mesh.fixed.push_back(0);
    EXPECT_EQ(refusal_of(mesh),
              "found nodes of no tetrahedron, wanted none: without mass or stiffness they make the problem singular: "
              "node 48 at (0.01, 0, -0.02) m");
}

/// Hard case 34.
TEST(MeshChecks, RefusesAMeshThatNothingHolds) {
    Mesh mesh = block();
    const std::string wanted =
        "found nothing fixed, wanted three nodes or more that are not on one line: without them the problem is singular";
    std::fill(mesh.fixed.begin(), mesh.fixed.end(), 0);
    expect_says(refusal_of(mesh), wanted);
    for (int n = 0; n < 4; ++n) mesh.fixed[n] = 1;
    expect_says(refusal_of(mesh), wanted);    // they are on one edge: it can turn about them
    mesh.fixed[4] = 1;
    EXPECT_EQ(refusal_of(mesh), "accepted");
}

TEST(MeshChecks, RefusesAMeshWithoutAFreeNode) {
    Mesh mesh = block();
    std::fill(mesh.fixed.begin(), mesh.fixed.end(), 1);
    expect_says(refusal_of(mesh), "found every node fixed, wanted some that are free");
}

/// Two blocks of the same tissue, a gap of 1 mm apart, that share the nodes which `merged` picks.
template <typename Merged>
Mesh two_blocks(Merged merged) {
    Mesh mesh = block(), other = block();
    std::vector<int> number;
    for (int n = 0; n < other.node_count(); ++n) {
        if (merged(other.nodes[n])) {    // its counterpart on the first block's right side
            number.push_back(n + 3);
            continue;
        }
        number.push_back(mesh.node_count());
        mesh.nodes.emplace_back(other.nodes[n] + Vector3(0.101, 0.0, 0.0));
        mesh.fixed.push_back(0);
    }
    for (Tetrahedron nodes : other.tetrahedra) {
        for (int& node : nodes) node = number[node];
        mesh.tetrahedra.push_back(nodes);
    }
    mesh.layers.resize(mesh.tetrahedra.size(), 0);
    return mesh;
}

bool at_left(const Vector3& node) {
    return node.x() == -0.05;
}

TEST(MeshChecks, RefusesAPartThatNothingHolds) {
    EXPECT_EQ(refusal_of(two_blocks(at_left)), "accepted");
    const std::string nothing_holds = "found parts that nothing holds";
    const std::string loose = refusal_of(two_blocks([](const Vector3&) { return false; }));
    expect_says(loose, nothing_holds);
    expect_says(loose, "108 tetrahedra around tetrahedron 108 (nodes");
    expect_says(refusal_of(two_blocks([](const Vector3& node) { return at_left(node) && node.z() == 0.0; })),
                nothing_holds);    // a hinge
}

TEST(MeshChecks, APartMayHangOnNodesOfAnother) {
    // At three corners: no face of the two is the same.
    EXPECT_EQ(refusal_of(two_blocks([](const Vector3& node) {
                  return at_left(node) && std::abs(node.y()) == 0.04 &&
                         (node.z() == 0.0 || (node.z() == -0.05 && node.y() > 0.0));
              })),
              "accepted");
}

TEST(MeshChecks, RefusesASecondBodyEvenWhereItIsHeld) {
    Mesh mesh = two_blocks([](const Vector3&) { return false; });
    for (int n = 0; n < mesh.node_count(); ++n) mesh.fixed[n] = mesh.nodes[n].z() == -0.05;
    const std::string found = refusal_of(mesh);
    expect_says(found, "found more than one body, wanted one (common nodes of neighbours not merged?): tetrahedron 108 (nodes");
    EXPECT_EQ(found.find("nothing holds"), std::string::npos);
}

TEST(MeshChecks, GathersAllThatIsWrongButListsTenOfAKind) {
    Mesh mesh = block();
    for (int t = 0; t < 13; ++t) std::swap(mesh.tetrahedra[t][0], mesh.tetrahedra[t][1]);
    mesh.tetrahedra.push_back(mesh.tetrahedra.back());
    mesh.nodes.emplace_back(0.0, 0.0, 0.0);
    mesh.fixed.push_back(0);
    const std::string found = refusal_of(mesh);
    for (const char* kind : {"found inverted tetrahedra", "found duplicate tetrahedra", "found nodes of no tetrahedron"}) {
        expect_says(found, kind);
    }
    expect_says(found, "tetrahedron 9 (nodes");
    EXPECT_EQ(found.find("tetrahedron 10 (nodes"), std::string::npos);
    expect_says(found, " and 3 more");
}

TEST(MeshChecks, RefusesAnEmptyMeshAtItsKey) {
    try {
        check_mesh({}, {}, "cells");
        FAIL() << "accepted";
    } catch (const Error& error) {
        EXPECT_EQ(error.key(), "cells");
        EXPECT_STREQ(error.what(), "found no tetrahedron, wanted at least one");
    }
}

}    // namespace
}    // namespace stylet::corotational_fem
