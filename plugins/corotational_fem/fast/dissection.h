// In which order the nodes are eliminated, and which dense blocks that leaves.
#pragma once

#include "fast/rest_matrix.h"

#include <vector>

namespace stylet::corotational_fem {

/// Nodes next to each other that are eliminated together.
struct Supernode {
    int first, size;         // places of its own nodes
    int rows_begin, rows;    // among Dissection::rows: the later places that it is tied to
};

/// Supernodes that one task works through in order, without a look at any other group of its stage.
struct Group {
    int begin, end;                // supernodes
    int first, size;               // places of its own nodes
    int outside_begin, outside;    // among Dissection::outside: the later places that its supernodes are tied to
    int parent;                    // the group that they all belong to or are outside of; −1: none
    int stage;
};

/// Nested dissection of a matrix's graph: its rows in places such that the factor fills in little, gathered into supernodes, and
/// those into groups that threads may share.
///
/// Deterministic: of the matrix alone, not of the number of threads. Parts that hang together by nothing are trees of their own.
struct Dissection {
    std::vector<int> place;               // of each row of the matrix
    std::vector<int> row;                 // of each place
    std::vector<int> place_of_node;       // of each mesh node; fixed ones have the one after the last, places()
    std::vector<int> supernode;           // of each place
    std::vector<Supernode> supernodes;    // children before parents; together their places have no gaps
    std::vector<int> rows;                // [places] ascending within a supernode
    std::vector<Group> groups;            // children before parents
    std::vector<int> outside;             // [places] ascending within a group
    int stages = 0;                       // the groups of a stage need those of earlier ones only

    [[nodiscard]] int places() const { return static_cast<int>(row.size()); }

    /// The supernode that holds the first of this one's rows; −1: none.
    [[nodiscard]] int parent(int s) const { return supernodes[s].rows == 0 ? -1 : supernode[rows[supernodes[s].rows_begin]]; }
};

[[nodiscard]] Dissection dissect(const BlockMatrix& matrix);

}    // namespace stylet::corotational_fem
