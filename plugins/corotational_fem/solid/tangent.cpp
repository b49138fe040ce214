#include "solid/tangent.h"

#include <algorithm>

namespace stylet::corotational_fem {

namespace {

// The nodes that one pressure or one tetrahedron couples.
std::vector<std::vector<int>> couplings(const Mesh& mesh, bool share_pressure) {
    std::vector<std::vector<int>> groups;
    for (int e = 0; e < mesh.size(); ++e) {
        const auto group = static_cast<std::size_t>(share_pressure ? mesh.patches[e] : e);
        if (groups.size() <= group) groups.resize(group + 1);
        groups[group].insert(groups[group].end(), mesh.tetrahedra[e].begin(), mesh.tetrahedra[e].end());
    }
    for (std::vector<int>& group : groups) {
        std::sort(group.begin(), group.end());
        group.erase(std::unique(group.begin(), group.end()), group.end());
    }
    return groups;
}

}    // namespace

Tangent::Tangent(const Mesh& mesh, bool share_pressure) : places_(mesh.nodes.size(), -1) {
    for (int node = 0; node < mesh.node_count(); ++node) {
        if (mesh.fixed[node] != 0) continue;
        places_[node] = free_nodes();
        nodes_.push_back(node);
    }
    std::vector<std::vector<int>> below(nodes_.size());    // of each free node the places from its own on that it meets
    for (const std::vector<int>& group : couplings(mesh, share_pressure)) {
        for (const int a : group) {
            for (const int b : group) {
                if (places_[b] >= 0 && places_[a] >= places_[b]) below[places_[b]].push_back(places_[a]);
            }
        }
    }
    std::vector<Eigen::Triplet<double>> entries;
    for (int column = 0; column < free_nodes(); ++column) {
        std::vector<int>& rows = below[column];
        std::sort(rows.begin(), rows.end());
        rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
        for (const int row : rows) {
            for (int i = 0; i < 3; ++i) {
                for (int j = 0; j < 3; ++j) {
                    if (3 * row + i >= 3 * column + j) entries.emplace_back(3 * row + i, 3 * column + j, 0.0);
                }
            }
        }
    }
    matrix_.resize(3 * free_nodes(), 3 * free_nodes());
    matrix_.setFromTriplets(entries.begin(), entries.end());
}

void Tangent::add(int a, int b, const Matrix3& block) {
    const int row = places_[a], column = places_[b];
    if (column < 0 || row < column) return;
    for (int j = 0; j < 3; ++j) {
        for (int i = row == column ? j : 0; i < 3; ++i) matrix_.coeffRef(3 * row + i, 3 * column + j) += block(i, j);
    }
}

}    // namespace stylet::corotational_fem
