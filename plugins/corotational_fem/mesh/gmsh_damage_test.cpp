// Files that are no meshes, or no longer.
#include "mesh/gmsh_file.h"

#include "mesh/mesh_file_for_tests.h"

#include <gtest/gtest.h>

#include <iostream>

namespace stylet::corotational_fem {
namespace {

std::string refusal_of(const std::string& text) {
    const MeshFile file(text);
    const std::string found = refusal([&] { (void)read_gmsh_file(file.path(), 1.0, cube_tissue(), ""); });
    return found.starts_with(file.path()) ? found.substr(file.path().size()) : found;
}

/// The cube of version 2.2 with one thing changed.
std::string changed_22(const std::string& what, const std::string& by) {
    return refusal_of(replaced(cube_22(), what, by));
}

std::string changed_41(const std::string& what, const std::string& by) {
    return refusal_of(replaced(cube_41(), what, by));
}

TEST(GmshDamage, ASoundFileIsAccepted) {
    EXPECT_EQ(refusal_of(cube_22()), "accepted");
    EXPECT_EQ(refusal_of(cube_41()), "accepted");
    EXPECT_EQ(changed_22("$Nodes", "$Comments\nby hand\n$EndComments\n$Nodes"), "accepted");
}

TEST(GmshDamage, SaysWhatFormatItWants) {
    EXPECT_EQ(refusal_of(""), ":1: found the end of the file, wanted $MeshFormat");
    EXPECT_EQ(refusal_of("solid cube\n"), ":1: found \"solid\", wanted $MeshFormat");
    EXPECT_EQ(refusal_of(std::string("\0\1\2\3 x", 6)), ":1: found \"????\", wanted $MeshFormat");
    EXPECT_EQ(changed_22("2.2 0 8", "4 0 8"),
              ":2: found version \"4\" of the format, wanted 2.2 or 4.1 (gmsh -format msh22 or -format msh41)");
    EXPECT_EQ(changed_22("2.2 0 8", "2.2 2 8"), ":2: found 2, wanted 0 for text or 1 for binary");
    EXPECT_EQ(changed_22("2.2 0 8", "2.2 1 8"),
              ": byte 20: found bytes in another order than this machine's, wanted the number one here");
    EXPECT_EQ(changed_22("2.2 0 8", "2.2 1 4"), ":2: found values of 4 bytes, wanted 8");
}

TEST(GmshDamage, SaysWhichValueIsWrong) {
    EXPECT_EQ(changed_22("31 -0.5", "31 -0,5"), ":12: found \"-0,5\", wanted a node's coordinate");
    EXPECT_EQ(changed_22("31 -0.5", "31 nan"), ":12: found a coordinate that is not finite, wanted a number");
    EXPECT_EQ(changed_22("31 -0.5", "31 1e999"), ":12: found \"1e999\", wanted a node's coordinate");
    EXPECT_EQ(changed_22("31 -0.5", "-31 -0.5"), ":12: found -31, wanted the tag of a node");
    EXPECT_EQ(changed_22("3 1 \"gel\"", "3 1 gel"), ":6: found \"gel\", wanted a physical group's name in quotation marks");
    EXPECT_EQ(changed_22("3 1 \"gel\"", "3 1 \"gel"), ":6: found \"\"gel\", wanted a physical group's name in quotation marks");
    EXPECT_EQ(changed_41("2 3 1 7", "2 3 4 7"),
              ":17: found nodes of dimension 2, parametric 4, wanted a dimension from 0 to 3, and 0 or 1");
    EXPECT_EQ(changed_41("2 3 1 7", "-9 3 1 7"),
              ":17: found nodes of dimension -9, parametric 1, wanted a dimension from 0 to 3, and 0 or 1");
}

TEST(GmshDamage, SaysWhatAnElementWants) {
    EXPECT_EQ(changed_22("900 7 12 44", "900 7 13 44"),
              ":21: found an element with the node 13, wanted nodes that $Nodes lists before it");
    EXPECT_EQ(changed_22("60 4 2", "60 11 2"),
              ":21: found an element of type 11 (of second order or higher, or unknown), wanted tetrahedra of four nodes (gmsh "
              "-order 1)");
    EXPECT_EQ(changed_41("3 3 4 6", "3 3 5 6"),
              ":35: found an element of type 5 (a hexahedron, prism or pyramid), wanted tetrahedra of four nodes");
    EXPECT_EQ(
        changed_22("60 4 2 1 1", "60 4 2 2 1"),
        ":21: found tetrahedron 60 in no named region (physical volume), wanted the name of one of the tissue's layers: \"gel\"");
    EXPECT_EQ(changed_22("7 0.5", "900 0.5"), ":17: found two nodes with the tag 900 up to here, wanted each tag once");
}

TEST(GmshDamage, SaysWhichSectionItWants) {
    EXPECT_EQ(changed_22("$EndNodes", ""), ":19: found \"$Elements\", wanted $EndNodes");
    EXPECT_EQ(changed_22("$Nodes\n8", "$Nodes\n7"), ":17: found \"44\", wanted $EndNodes");
    EXPECT_EQ(changed_22("$Nodes\n8", "$Nodes\n9"), ":18: found \"$EndNodes\", wanted the tag of a node");
    EXPECT_EQ(changed_41("2 8 5 800000", "2 9 5 800000"),
              ":31: found 8 nodes up to here, wanted the 9 that the section announces");
    EXPECT_EQ(changed_41("1 6 10 60", "1 7 10 60"), ":41: found 6 elements up to here, wanted the 7 that the section announces");
    const std::string no_elements = cube_22().substr(0, cube_22().find("$Elements"));
    EXPECT_EQ(refusal_of(no_elements), ": found no $Elements, wanted that section");
    EXPECT_EQ(refusal_of(no_elements + "$Nodes\n"), ":19: found $Nodes a second time, wanted it once");
    EXPECT_EQ(refusal_of(no_elements + "$NodeData\n1\n"), ":19: found the end of the file after this, wanted $EndNodeData");
    EXPECT_EQ(refusal_of(no_elements + "Elements\n"), ":19: found \"Elements\", wanted the begin of a section such as $Nodes");
    EXPECT_EQ(changed_22("$Nodes", "$PartitionedEntities"), ":8: found a mesh in partitions, wanted it in one piece");
}

TEST(GmshDamage, SaysWhenThereIsNothingToSolve) {
    const std::string nodes = cube_22().substr(0, cube_22().find("$Elements"));
    EXPECT_EQ(refusal_of(nodes + "$Elements\n1\n1 2 0 900 7 12\n$EndElements\n"),
              ": found no tetrahedron of four nodes, wanted a mesh of them");
}

/// An array of this many would not fit into any machine.
TEST(GmshDamage, BelievesNoCountThatTheFileCannotHold) {
    const std::string huge = "4000000000000000000";
    EXPECT_EQ(changed_22("$Nodes\n8", "$Nodes\n" + huge),
              ":9: found a count of 4000000000000000000 nodes, wanted no more than the rest of the file can hold, 38");
    EXPECT_EQ(changed_22("$Elements\n6", "$Elements\n" + huge),
              ":20: found a count of 4000000000000000000 elements, wanted no more than the rest of the file can hold, 27");
    EXPECT_NE(changed_41("2 8 5 800000", huge + " 8 5 800000").find("found a count of"), std::string::npos);
    EXPECT_NE(changed_41("2 8 5 800000", "2 " + huge + " 5 800000").find("found a count of"), std::string::npos);
    EXPECT_NE(changed_41("2 3 1 7", "2 3 1 " + huge).find("found a count of"), std::string::npos);
    EXPECT_NE(changed_41("3 3 4 6", "3 3 4 " + huge).find("found a count of"), std::string::npos);
    EXPECT_NE(changed_41("0 0 0 1\n3", "0 0 0 " + huge + "\n3").find("found a count of"), std::string::npos);
    EXPECT_NE(changed_22("$PhysicalNames\n1", "$PhysicalNames\n2000000000"), "accepted");
    EXPECT_NE(changed_22("60 4 2", "60 4 2000000000"), "accepted");
    EXPECT_NE(changed_22("$Nodes\n8", "$Nodes\n-8"), "accepted");
}

std::string contents(const std::string& name) {
    std::ifstream stream(STYLET_TEST_MESHES "/" + name, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

/// Bytes changed, lines lost, ends cut off: whatever comes of it, it is read or refused.
TEST(GmshDamage, NothingCrashesTheReader) {
    std::mt19937 random(11);
    const auto below = [&](std::size_t limit) { return std::uniform_int_distribution<std::size_t>(0, limit - 1)(random); };
    int accepted = 0, refused = 0;
    for (const std::string name :
         {"two_layers_22.msh", "two_layers_22_binary.msh", "two_layers_41.msh", "two_layers_41_binary.msh", ""}) {
        const std::string sound = name.empty() ? cube_41() : contents(name);
        for (int i = 0; i < 300; ++i) {
            std::string text = sound;
            for (std::size_t changes = 1 + below(4); changes > 0 && !text.empty(); --changes) {
                const std::size_t at = below(i % 2 == 0 ? text.size() : std::min<std::size_t>(text.size(), 2000));
                switch (below(5)) {
                    case 0:
                        text[at] = static_cast<char>(below(256));
                        break;
                    case 1:
                        text[at] = "0123456789-.e $\n"[below(16)];
                        break;
                    case 2:
                        text.erase(at, below(100));
                        break;
                    case 3:
                        text.insert(at, text.substr(below(text.size()), below(200)));
                        break;
                    default:
                        text.resize(at + 1);
                }
            }
            const MeshFile file(text);
            const std::string found = refusal([&] { (void)read_gmsh_file(file.path(), 1e-3, skin_and_muscle(), ""); });
            ++(found == "accepted" ? accepted : refused);
            EXPECT_LT(found.size(), 20000U);
        }
    }
    std::cout << accepted << " accepted, " << refused << " refused\n";
    EXPECT_GT(refused, accepted);
}

}    // namespace
}    // namespace stylet::corotational_fem
