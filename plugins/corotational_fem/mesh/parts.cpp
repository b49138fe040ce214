#include "mesh/parts.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace stylet::corotational_fem {
namespace {

/// Sets of tetrahedra that were joined (Tarjan 1975).
class Sets {
public:
    explicit Sets(int count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0); }

    void join(int a, int b) { parent_[root(a)] = root(b); }

    /// Of each member, the number of its set, counted from 0 in order of first members.
    std::vector<int> numbers() {
        std::vector<int> of_root(parent_.size(), -1), numbers(parent_.size());
        int count = 0;
        for (int i = 0; i < static_cast<int>(parent_.size()); ++i) {
            int& number = of_root[root(i)];
            if (number < 0) number = count++;
            numbers[i] = number;
        }
        return numbers;
    }

private:
    int root(int member) {
        while (parent_[member] != member) member = parent_[member] = parent_[parent_[member]];
        return member;
    }

    std::vector<int> parent_;
};

std::vector<int> bodies_of(const Mesh& mesh) {
    Sets sets(mesh.size());
    std::vector<int> first(mesh.nodes.size(), -1);    // tetrahedron at a node
    for (int t = 0; t < mesh.size(); ++t) {
        for (const int node : mesh.tetrahedra[t]) {
            if (first[node] < 0) first[node] = t;
            sets.join(t, first[node]);
        }
    }
    return sets.numbers();
}

int count_of(const std::vector<int>& numbers) {
    return 1 + *std::max_element(numbers.begin(), numbers.end());
}

/// What fixed points leave of a part's freedom.
class Grip {
public:
    /// True once three points that it took are not on one line.
    bool take(const Vector3& point) {
        constexpr double straight = 1e-6;    // sine of the widest angle that still counts as a line
        if (empty_) first_ = point;
        empty_ = false;
        const Vector3 from_first = point - first_;
        if (line_.isZero(0.0)) line_ = from_first;
        return line_.cross(from_first).norm() > straight * line_.norm() * from_first.norm();
    }

private:
    bool empty_ = true;
    Vector3 first_, line_ = Vector3::Zero();
};

/// What touches a node, without repetition.
std::vector<std::vector<int>> parts_at_nodes(const Mesh& mesh, const std::vector<int>& part) {
    std::vector<std::vector<int>> parts(mesh.nodes.size());
    for (int t = 0; t < mesh.size(); ++t) {
        for (const int node : mesh.tetrahedra[t]) {
            auto& at_node = parts[node];
            if (std::find(at_node.begin(), at_node.end(), part[t]) == at_node.end()) at_node.push_back(part[t]);
        }
    }
    return parts;
}

std::vector<std::vector<int>> tetrahedra_by_part(const std::vector<int>& part) {
    std::vector<std::vector<int>> tetrahedra(count_of(part));
    for (std::size_t t = 0; t < part.size(); ++t) tetrahedra[part[t]].push_back(static_cast<int>(t));
    return tetrahedra;
}

/// From the fixed nodes on: what is held holds its neighbours.
std::vector<char> held_parts(const Mesh& mesh, const std::vector<int>& part) {
    const auto parts = parts_at_nodes(mesh, part), tetrahedra = tetrahedra_by_part(part);
    std::vector<Grip> grips(tetrahedra.size());
    std::vector<char> is_held(tetrahedra.size(), 0), node_is_held = mesh.fixed;
    std::vector<int> held;    // nodes
    for (int n = 0; n < mesh.node_count(); ++n) {
        if (node_is_held[n] != 0) held.push_back(n);
    }
    for (std::size_t next = 0; next < held.size(); ++next) {
        for (const int p : parts[held[next]]) {
            if (is_held[p] != 0 || !grips[p].take(mesh.nodes[held[next]])) continue;
            is_held[p] = 1;
            for (const int t : tetrahedra[p]) {
                for (const int node : mesh.tetrahedra[t]) {
                    if (std::exchange(node_is_held[node], 1) == 0) held.push_back(node);
                }
            }
        }
    }
    return is_held;
}

}    // namespace

Parts parts_of(const Mesh& mesh, std::span<const FaceUse> sorted_faces) {
    Sets sets(mesh.size());
    for (std::size_t i = 1; i < sorted_faces.size(); ++i) {
        if (sorted_faces[i].nodes == sorted_faces[i - 1].nodes) {
            sets.join(sorted_faces[i].tetrahedron, sorted_faces[i - 1].tetrahedron);
        }
    }
    Parts parts{.body = bodies_of(mesh), .part = sets.numbers(), .is_held = {}};
    parts.is_held = held_parts(mesh, parts.part);
    parts.body_count = count_of(parts.body);
    return parts;
}

}    // namespace stylet::corotational_fem
