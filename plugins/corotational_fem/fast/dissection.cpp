#include "fast/dissection.h"

#include "fast/lanes.h"

#include <metis.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <new>
#include <numeric>

namespace stylet::corotational_fem {

namespace {

// Measured, at 2,560 nodes on a processor with 2 MB of cache: what a supernode costs besides its tiles, and what a tile of M
// does, which a solve reads twice, but the second time now and then from the cache.
constexpr double supernode_cost = 2.0;    // [tiles]
constexpr double below_cost = 1.7;        // [tiles]

// Of the whole cost, how much a group and all below it may come to: in the first stage, where each group is a task of many, and
// in the next ones, where there are fewer and fewer. A smaller subtree than the least goes with its parent.
constexpr std::array largest{0.06, 0.3, 0.6};
constexpr double least = 0.01;

int tiles(int nodes) {
    return (3 * nodes + lanes - 1) / lanes;
}

// Of a supernode's part in a solve, in tiles read (kernels.h).
double cost(int size, int rows) {
    const int own = tiles(size);
    return own * (own + 1) / 2.0 + below_cost * own * tiles(rows) + supernode_cost;
}

// The place of each row in METIS's order.
std::vector<int> fill_reducing_order(const BlockMatrix& matrix) {
    idx_t count = matrix.rows();
    std::vector<idx_t> start{0}, neighbours, order(count), place(count);
    for (int row = 0; row < count; ++row) {
        for (int at = matrix.start[row]; at < matrix.start[row + 1]; ++at) {
            if (matrix.column[at] != row) neighbours.push_back(matrix.column[at]);
        }
        start.push_back(static_cast<idx_t>(neighbours.size()));
    }
    if (neighbours.empty()) {    // METIS wants an edge
        std::iota(place.begin(), place.end(), 0);
        return place;
    }
    idx_t options[METIS_NOPTIONS];
    METIS_SetDefaultOptions(options);
    options[METIS_OPTION_SEED] = 1;    // of the C library's rand(), which METIS takes its random numbers from
    if (METIS_NodeND(&count, start.data(), neighbours.data(), nullptr, options, order.data(), place.data()) != METIS_OK) {
        throw std::bad_alloc();    // its one way to fail with a graph as good as this
    }
    return place;
}

// A supernode while the tree is still being shaped; it begins as one column.
struct Branch {
    std::vector<int> columns;     // of METIS's order
    std::vector<int> rows;        // later columns that the last of them is tied to, ascending
    std::vector<int> children;    // branches
    double total = 0.0;           // cost of it and all below it

    [[nodiscard]] double own_cost() const { return cost(static_cast<int>(columns.size()), static_cast<int>(rows.size())); }
};

struct Tree {
    std::vector<Branch> branches;    // merged ones stay behind, empty
    std::vector<int> roots;
};

// One branch for each column: the elimination tree with the structure of the factor's columns.
Tree elimination_tree(const BlockMatrix& matrix, const std::vector<int>& place) {
    const int count = matrix.rows();
    Tree tree{std::vector<Branch>(count), {}};
    std::vector<int> row_at(count), seen(count, -1);
    for (int row = 0; row < count; ++row) row_at[place[row]] = row;
    for (int column = 0; column < count; ++column) {
        Branch& branch = tree.branches[column];
        branch.columns = {column};
        seen[column] = column;
        const auto see = [&](int other) {
            if (other <= column || seen[other] == column) return;
            seen[other] = column;
            branch.rows.push_back(other);
        };
        const int row = row_at[column];
        for (int at = matrix.start[row]; at < matrix.start[row + 1]; ++at) see(place[matrix.column[at]]);
        for (const int child : branch.children) {
            for (const int other : tree.branches[child].rows) see(other);
        }
        std::sort(branch.rows.begin(), branch.rows.end());
        if (branch.rows.empty()) {
            tree.roots.push_back(column);
        } else {
            tree.branches[branch.rows.front()].children.push_back(column);
        }
    }
    return tree;
}

double gain(const Branch& parent, const Branch& child) {
    const int size = static_cast<int>(parent.columns.size() + child.columns.size());
    return parent.own_cost() + child.own_cost() - cost(size, static_cast<int>(parent.rows.size()));
}

// Merges children into their parents, the best first, for as long as it makes a solve cheaper.
void merge(Tree& tree) {
    for (Branch& parent : tree.branches) {
        while (!parent.children.empty()) {
            const auto better = [&](int a, int b) { return gain(parent, tree.branches[a]) < gain(parent, tree.branches[b]); };
            const auto best = std::max_element(parent.children.begin(), parent.children.end(), better);
            Branch& child = tree.branches[*best];
            if (gain(parent, child) <= 0.0) break;
            parent.children.erase(best);
            parent.columns.insert(parent.columns.begin(), child.columns.begin(), child.columns.end());
            parent.children.insert(parent.children.end(), child.children.begin(), child.children.end());
            child = Branch{};
        }
        parent.total = parent.columns.empty() ? 0.0 : parent.own_cost();
        for (const int child : parent.children) parent.total += tree.branches[child].total;
    }
}

void gather(const Tree& tree, int root, std::vector<int>& into) {
    into.push_back(root);
    for (const int child : tree.branches[root].children) gather(tree, child, into);
}

// Replaces the dearest of these subtrees by its children until none costs more than `most`, and takes out those of less than
// `smallest`; returns the branches that went.
std::vector<int> split(const Tree& tree, std::vector<int>& subtrees, double most, double smallest) {
    std::vector<int> removed;
    const auto cheaper = [&](int a, int b) { return tree.branches[a].total < tree.branches[b].total; };
    while (!subtrees.empty()) {
        const auto dearest = std::max_element(subtrees.begin(), subtrees.end(), cheaper);
        const Branch& branch = tree.branches[*dearest];
        if (branch.children.empty() || branch.total <= most) break;
        removed.push_back(*dearest);
        subtrees.erase(dearest);
        subtrees.insert(subtrees.end(), branch.children.begin(), branch.children.end());
    }
    const auto small =
        std::partition(subtrees.begin(), subtrees.end(), [&](int b) { return tree.branches[b].total >= smallest; });
    for (auto subtree = small; subtree != subtrees.end(); ++subtree) gather(tree, *subtree, removed);
    subtrees.erase(small, subtrees.end());
    return removed;
}

using Stages = std::array<std::vector<std::vector<int>>, largest.size() + 1>;    // the branches of each group

// These subtrees and what ties them together, which are of this stage and earlier ones.
void add_groups(const Tree& tree, std::vector<int> subtrees, double whole, std::size_t stage, Stages& stages) {
    if (stage == 0) {
        for (const int subtree : subtrees) gather(tree, subtree, stages[0].emplace_back());
        return;
    }
    stages[stage].push_back(split(tree, subtrees, largest[stage - 1] * whole, least * whole));
    if (stage == 1) {
        add_groups(tree, subtrees, whole, 0, stages);
    } else {
        for (const int subtree : subtrees) add_groups(tree, {subtree}, whole, stage - 1, stages);
    }
}

Stages groups(const Tree& tree) {
    double whole = 0.0;
    for (const int root : tree.roots) whole += tree.branches[root].total;
    Stages stages;
    add_groups(tree, tree.roots, whole, largest.size(), stages);
    for (std::vector<std::vector<int>>& stage : stages) {
        std::erase_if(stage, [](const std::vector<int>& group) { return group.empty(); });
        for (std::vector<int>& group : stage) std::sort(group.begin(), group.end());
    }
    return stages;
}

// Gives a branch the next places.
void place(const Branch& branch, const std::vector<int>& row_at, Dissection& into, std::vector<int>& place_of_column) {
    into.supernodes.push_back({into.places(), static_cast<int>(branch.columns.size()), 0, 0});
    into.supernode.insert(into.supernode.end(), branch.columns.size(), static_cast<int>(into.supernodes.size()) - 1);
    for (const int column : branch.columns) {
        place_of_column[column] = into.places();
        into.place[row_at[column]] = into.places();
        into.row.push_back(row_at[column]);
    }
}

void add_rows(Supernode& supernode, const Branch& branch, const std::vector<int>& place_of_column, std::vector<int>& rows) {
    supernode.rows_begin = static_cast<int>(rows.size());
    supernode.rows = static_cast<int>(branch.rows.size());
    for (const int column : branch.rows) rows.push_back(place_of_column[column]);
    std::sort(rows.begin() + supernode.rows_begin, rows.end());
}

// What is outside of each group, and which group that makes its parent.
void tie(Dissection& d) {
    for (Group& group : d.groups) {
        std::vector<int> outside;
        for (int s = group.begin; s < group.end; ++s) {
            const auto begin = d.rows.begin() + d.supernodes[s].rows_begin;
            std::copy_if(begin, begin + d.supernodes[s].rows, std::back_inserter(outside),
                         [&](int place) { return place >= group.first + group.size; });
        }
        std::sort(outside.begin(), outside.end());
        outside.erase(std::unique(outside.begin(), outside.end()), outside.end());
        group.outside_begin = static_cast<int>(d.outside.size());
        group.outside = static_cast<int>(outside.size());
        d.outside.insert(d.outside.end(), outside.begin(), outside.end());
        group.parent = -1;
        if (outside.empty()) continue;
        group.parent = 0;
        while (d.groups[group.parent].first + d.groups[group.parent].size <= outside.front()) ++group.parent;
    }
}

}    // namespace

Dissection dissect(const BlockMatrix& matrix) {
    const std::vector<int> first_order = fill_reducing_order(matrix);
    Tree tree = elimination_tree(matrix, first_order);
    merge(tree);

    Dissection d;
    d.place.resize(matrix.rows());
    std::vector<int> row_at(matrix.rows()), place_of_column(matrix.rows()), order;
    for (int row = 0; row < matrix.rows(); ++row) row_at[first_order[row]] = row;
    for (const std::vector<std::vector<int>>& stage : groups(tree)) {
        for (const std::vector<int>& group : stage) {
            const int begin = static_cast<int>(d.supernodes.size()), first = d.places();
            for (const int branch : group) place(tree.branches[branch], row_at, d, place_of_column);
            order.insert(order.end(), group.begin(), group.end());
            d.groups.push_back({begin, static_cast<int>(d.supernodes.size()), first, d.places() - first, 0, 0, -1, d.stages});
        }
        if (!stage.empty()) ++d.stages;
    }
    for (std::size_t s = 0; s < order.size(); ++s) add_rows(d.supernodes[s], tree.branches[order[s]], place_of_column, d.rows);
    tie(d);
    for (const int row : matrix.row) d.place_of_node.push_back(row < 0 ? d.places() : d.place[row]);
    return d;
}

}    // namespace stylet::corotational_fem
