#include "fast/dissection.h"

#include "fast/rest_for_tests.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace stylet::corotational_fem {
namespace {

using namespace testing;

const std::vector<Material> gel = alike(elastic(25e3, 0.49, 1000.0));

std::vector<BlockMatrix> matrices() {
    Mesh two_pieces = uneven_block({6, 5, 4});
    Mesh other = two_pieces;
    const int nodes = two_pieces.node_count();
    for (Vector3& x : other.nodes) x.x() += 1.0;
    for (Tetrahedron& t : other.tetrahedra) {
        for (int& node : t) node += nodes;
    }
    two_pieces.nodes.insert(two_pieces.nodes.end(), other.nodes.begin(), other.nodes.end());
    two_pieces.tetrahedra.insert(two_pieces.tetrahedra.end(), other.tetrahedra.begin(), other.tetrahedra.end());
    two_pieces.fixed.insert(two_pieces.fixed.end(), other.fixed.begin(), other.fixed.end());
    two_pieces.layers.insert(two_pieces.layers.end(), other.layers.begin(), other.layers.end());
    return {rest_matrix(uneven_block({10, 9, 8}), gel, quasi_static()),
            rest_matrix(uneven_block({7, 7, 5}), gel, with_shared_pressure(quasi_static())),
            rest_matrix(two_pieces, gel, quasi_static()), rest_matrix(uneven_block({1, 1, 1}), gel, quasi_static())};
}

TEST(Dissection, GivesEachRowAPlaceOfItsOwn) {
    for (const BlockMatrix& a : matrices()) {
        const Dissection d = dissect(a);
        ASSERT_EQ(d.places(), a.rows());
        for (int row = 0; row < a.rows(); ++row) {
            EXPECT_EQ(d.row[d.place[row]], row);
            EXPECT_EQ(d.place_of_node[a.mesh_node[row]], d.place[row]);
        }
        for (std::size_t node = 0; node < a.row.size(); ++node) {
            if (a.row[node] < 0) {
                EXPECT_EQ(d.place_of_node[node], d.places());
            }
        }
    }
}

TEST(Dissection, HasNoGapsBetweenSupernodesNorBetweenGroups) {
    for (const BlockMatrix& a : matrices()) {
        const Dissection d = dissect(a);
        int place = 0, supernode = 0, stage = 0;
        for (const Group& group : d.groups) {
            EXPECT_EQ(group.begin, supernode);
            EXPECT_EQ(group.first, place);
            EXPECT_GE(group.stage, stage);
            stage = group.stage;
            for (; supernode < group.end; ++supernode) {
                EXPECT_EQ(d.supernodes[supernode].first, place);
                for (int i = 0; i < d.supernodes[supernode].size; ++i) EXPECT_EQ(d.supernode[place++], supernode);
            }
            EXPECT_EQ(group.first + group.size, place);
        }
        EXPECT_EQ(place, d.places());
        EXPECT_EQ(stage + 1, d.stages);
    }
}

// Eliminating a supernode ties all its rows to each other: so they must be its parent's own or rows of its parent.
TEST(Dissection, KeepsRoomForAllThatFillsIn) {
    for (const BlockMatrix& a : matrices()) {
        const Dissection d = dissect(a);
        const auto holds = [&](int s, int place) {
            const Supernode& supernode = d.supernodes[s];
            const auto begin = d.rows.begin() + supernode.rows_begin;
            return d.supernode[place] == s || std::binary_search(begin, begin + supernode.rows, place);
        };
        for (int s = 0; s < static_cast<int>(d.supernodes.size()); ++s) {
            const Supernode& supernode = d.supernodes[s];
            for (int i = 0; i < supernode.rows; ++i) EXPECT_TRUE(holds(d.parent(s), d.rows[supernode.rows_begin + i]));
        }
        for (int row = 0; row < a.rows(); ++row) {
            for (int at = a.start[row]; at < a.start[row + 1]; ++at) {
                const int place = d.place[a.column[at]];
                if (place > d.place[row]) {
                    EXPECT_TRUE(holds(d.supernode[d.place[row]], place));
                }
            }
        }
    }
}

TEST(Dissection, TiesAGroupToItsParentsAlone) {
    for (const BlockMatrix& a : matrices()) {
        const Dissection d = dissect(a);
        for (const Group& group : d.groups) {
            std::set<int> outside;
            for (int s = group.begin; s < group.end; ++s) {
                for (int i = 0; i < d.supernodes[s].rows; ++i) {
                    const int place = d.rows[d.supernodes[s].rows_begin + i];
                    if (place >= group.first + group.size) outside.insert(place);
                }
            }
            const auto begin = d.outside.begin() + group.outside_begin;
            EXPECT_TRUE(std::equal(outside.begin(), outside.end(), begin, begin + group.outside));
            if (group.parent < 0) {
                EXPECT_TRUE(outside.empty());
                continue;
            }
            const Group& parent = d.groups[group.parent];
            EXPECT_GT(parent.stage, group.stage);
            const auto theirs = d.outside.begin() + parent.outside_begin;
            for (const int place : outside) {
                EXPECT_TRUE((place >= parent.first && place < parent.first + parent.size) ||
                            std::binary_search(theirs, theirs + parent.outside, place));
            }
        }
    }
}

TEST(Dissection, IsTheSameEachTime) {
    const BlockMatrix a = rest_matrix(uneven_block({10, 9, 8}), gel, quasi_static());
    EXPECT_EQ(dissect(a).place, dissect(a).place);
}

TEST(Dissection, HasSeveralTasksToShare) {
    const Dissection d = dissect(rest_matrix(uneven_block({10, 9, 8}), gel, quasi_static()));
    const auto first = std::count_if(d.groups.begin(), d.groups.end(), [](const Group& group) { return group.stage == 0; });
    std::printf("%zu supernodes in %zu groups, %ld of them in the first of %d stages\n", d.supernodes.size(), d.groups.size(),
                static_cast<long>(first), d.stages);
    EXPECT_GE(first, 8);
}

}    // namespace
}    // namespace stylet::corotational_fem
