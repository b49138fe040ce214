#include "fast/factor.h"

#include <stylet/error.h>

#include <unistd.h>

#include <algorithm>
#include <sstream>

namespace stylet::corotational_fem {

namespace {

// A pivot that has shrunk to this part of what it was is rounding alone: eliminating some 10⁴ unknowns leaves errors of about 100
// units in the last place (2·10⁻¹⁶), while the softest motion of a tissue whose layers differ by 10⁶ leaves 10⁻¹⁰.
constexpr double rounding = 1e-13;

// The rest is for fronts, and for what the blocks are copied to.
std::size_t half_of_memory() {
    return static_cast<std::size_t>(sysconf(_SC_PHYS_PAGES)) / 2 * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

void refuse_size(std::size_t bytes) {
    if (bytes <= half_of_memory()) return;
    constexpr double giga = 1e9;
    std::ostringstream text;
    text.precision(2);
    text << std::fixed << "found a mesh whose factor takes " << static_cast<double>(bytes) / giga << " GB, wanted one of at most "
         << static_cast<double>(half_of_memory()) / giga << " GB, half of this machine's memory: a coarser one";
    throw Error(text.str());
}

}    // namespace

Factor::Factor(const Dissection& dissection, InstructionSet set)
    : dissection_(dissection),
      kernel_(dense_kernel(set)),
      children_(dissection.supernodes.size()),
      updates_(dissection.supernodes.size()) {
    for (int s = 0; s < static_cast<int>(children_.size()); ++s) {
        if (const int parent = dissection.parent(s); parent >= 0) children_[parent].push_back(s);
    }
    std::size_t count = 0;
    for (const Supernode& supernode : dissection.supernodes) {
        at_.push_back(count);
        count += std::size_t{9} * supernode.size * (supernode.size + supernode.rows);
    }
    refuse_size(count * sizeof(double));
    values_.resize(count);
}

// Threads share the groups of the first stage, and after that, where there are few and large ones, each front.
void Factor::refactor(const BlockMatrix& matrix, Workers& workers) {
    const std::vector<Group>& groups = dissection_.groups;
    std::vector<int> singular(groups.size(), -1);
    const auto eliminate_all = [&](int g, Workers& within) {
        for (int s = groups[g].begin; s < groups[g].end && singular[g] < 0; ++s) {
            if (!eliminate(s, matrix, within)) singular[g] = s;
        }
    };
    const auto is_first = [](const Group& group) { return group.stage == 0; };
    const int first = static_cast<int>(std::count_if(groups.begin(), groups.end(), is_first));
    workers.each(first, [&](int g) { eliminate_all(g, one_thread()); });
    for (int g = 0; g < static_cast<int>(groups.size()); ++g) {
        if (g >= first) eliminate_all(g, workers);
        if (singular[g] >= 0) refuse(matrix.mesh_node[dissection_.row[dissection_.supernodes[singular[g]].first]]);
    }
}

void Factor::refuse(int node) {
    for (std::vector<double>& update : updates_) update = std::vector<double>();
    throw Error("singular: about node " + std::to_string(node) +
                " found a part of the tissue that nothing holds, or a material that no pressure keeps in shape; wanted fixed "
                "nodes that keep each connected part from moving and from turning, and materials with μ > 0 and λ > −2μ/3");
}

// False where the supernode's own block is not positive definite.
bool Factor::eliminate(int s, const BlockMatrix& matrix, Workers& workers) {
    const Supernode& supernode = dissection_.supernodes[s];
    const int own = 3 * supernode.size, below = 3 * supernode.rows;
    Front front(own, below, kernel_);
    add_matrix(supernode, matrix, front);
    std::vector<double> least(own);
    for (int i = 0; i < own; ++i) least[i] = rounding * front(i, i);
    for (const int child : children_[s]) add_update(supernode, child, front);
    if (!front.sweep(least, workers)) return false;

    Eigen::Map<MatrixX> inverse(values_.data() + at_[s], own, own), to_rows(inverse.data() + inverse.size(), below, own);
    for (int j = 0; j < own; ++j) {
        for (int i = j; i < own; ++i) inverse(i, j) = inverse(j, i) = -front(i, j);
        for (int i = 0; i < below; ++i) to_rows(i, j) = front(own + i, j);
    }
    updates_[s].reserve(static_cast<std::size_t>(below) * (below + 1) / 2);
    for (int j = own; j < own + below; ++j) updates_[s].insert(updates_[s].end(), &front(j, j), &front(j, j) + own + below - j);
    return true;
}

// Which row of a supernode's front a place is at; of those that it has.
int Factor::position(const Supernode& supernode, int place) const {
    if (place < supernode.first + supernode.size) return 3 * (place - supernode.first);
    const auto begin = dissection_.rows.begin() + supernode.rows_begin;
    return 3 * (supernode.size + static_cast<int>(std::lower_bound(begin, begin + supernode.rows, place) - begin));
}

void Factor::add_matrix(const Supernode& supernode, const BlockMatrix& matrix, Front& front) const {
    for (int i = 0; i < supernode.size; ++i) {
        const int row = dissection_.row[supernode.first + i];
        for (int at = matrix.start[row]; at < matrix.start[row + 1]; ++at) {
            const int place = dissection_.place[matrix.column[at]];
            if (place < supernode.first + i) continue;
            const int below = position(supernode, place);
            for (int a = 0; a < 3; ++a) {
                for (int b = 0; b < 3; ++b) front(below + a, 3 * i + b) += matrix.block[at](b, a);
            }
        }
    }
}

void Factor::add_update(const Supernode& supernode, int child, Front& front) {
    const Supernode& from = dissection_.supernodes[child];
    const int count = 3 * from.rows;
    std::vector<int> at(count);
    for (int i = 0; i < count; ++i) at[i] = position(supernode, dissection_.rows[from.rows_begin + i / 3]) + i % 3;
    const double* update = updates_[child].data();
    for (int j = 0; j < count; ++j) {
        double* const column = &front(0, at[j]);
        for (int i = j; i < count; ++i) column[at[i]] += *update++;
    }
    updates_[child] = std::vector<double>();    // {} would keep its room
}

void Factor::solve(Eigen::Ref<VectorX> x) const {
    const int count = static_cast<int>(at_.size());
    VectorX rows;
    for (int s = 0; s < count; ++s) {
        const Supernode& supernode = dissection_.supernodes[s];
        rows = below(s) * x.segment(3 * supernode.first, 3 * supernode.size);
        for (int i = 0; i < supernode.rows; ++i) {
            x.segment<3>(3 * dissection_.rows[supernode.rows_begin + i]) -= rows.segment<3>(3 * i);
        }
    }
    for (int s = count - 1; s >= 0; --s) {
        const Supernode& supernode = dissection_.supernodes[s];
        rows.resize(3 * supernode.rows);
        for (int i = 0; i < supernode.rows; ++i) {
            rows.segment<3>(3 * i) = x.segment<3>(3 * dissection_.rows[supernode.rows_begin + i]);
        }
        auto own = x.segment(3 * supernode.first, 3 * supernode.size);
        own = (inverse(s) * own - below(s).transpose() * rows).eval();
    }
}

}    // namespace stylet::corotational_fem
