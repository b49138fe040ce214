#include "mesh/patches.h"

#include "mesh/buckets.h"
#include "mesh/faces.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace stylet::corotational_fem {
namespace {

constexpr std::size_t fewest = 6, most = 14;    // tetrahedra in a patch
constexpr int none = -1;

/// The positions 0, 1, 2 … sorted by `less`.
template <typename Less>
std::vector<int> sorted_positions(std::size_t count, Less less) {
    std::vector<int> positions(count);
    std::iota(positions.begin(), positions.end(), 0);
    std::sort(positions.begin(), positions.end(), less);
    return positions;
}

/// Puts a mesh's tetrahedra into patches in an order that its numbering has no part in.
class Grouping {
public:
    explicit Grouping(const Mesh& mesh)
        : mesh_(mesh),
          neighbours_(neighbours_of(mesh)),
          patch_(mesh.tetrahedra.size(), none),
          asked_(mesh.tetrahedra.size(), none) {
        order_nodes();
        order_tetrahedra();
    }

    std::vector<int> run() {
        for (const int node : node_order_) group_around(node);
        join_leftovers();
        for (const int t : order_) {
            if (patch_[t] == none) close(component(t, [](int) { return true; }));
        }
        return patch_;
    }

private:
    void order_nodes() {
        constexpr double rounding = 1e-9;    // of the size: nodes on one plane of a file may differ by this
        Box box;
        for (const Vector3& node : mesh_.nodes) box.take_in(node);
        const double quantum = rounding * box.size().norm();
        std::vector<std::array<std::int64_t, 3>> places;
        for (const Vector3& node : mesh_.nodes) {
            const Vector3 steps = (node - box.least) / quantum;
            places.push_back({std::llround(steps.z()), std::llround(steps.y()), std::llround(steps.x())});
        }
        node_order_ = sorted_positions(places.size(), [&](int a, int b) { return places[a] < places[b]; });
        node_rank_.resize(node_order_.size());
        for (std::size_t i = 0; i < node_order_.size(); ++i) node_rank_[node_order_[i]] = static_cast<int>(i);
    }

    void order_tetrahedra() {
        std::vector<Tetrahedron> ranks;
        for (const Tetrahedron& nodes : mesh_.tetrahedra) {
            Tetrahedron& of = ranks.emplace_back();
            std::transform(nodes.begin(), nodes.end(), of.begin(), [&](int n) { return node_rank_[n]; });
            std::sort(of.begin(), of.end());
        }
        order_ = sorted_positions(ranks.size(), [&](int a, int b) { return ranks[a] < ranks[b]; });
        rank_.resize(order_.size());
        stars_.resize(mesh_.nodes.size());
        for (std::size_t i = 0; i < order_.size(); ++i) {
            rank_[order_[i]] = static_cast<int>(i);
            for (const int node : mesh_.tetrahedra[order_[i]]) stars_[node].push_back(order_[i]);
        }
    }

    /// The neighbours of a tetrahedron in its layer, in order.
    std::vector<int> beside(int t) const {
        std::vector<int> found;
        for (const int other : neighbours_[t]) {
            if (other != no_neighbour && mesh_.layers[other] == mesh_.layers[t]) found.push_back(other);
        }
        std::sort(found.begin(), found.end(), [&](int a, int b) { return rank_[a] < rank_[b]; });
        return found;
    }

    /// The tetrahedra of no patch that are connected with t, in its layer, through those that `among` admits; nearest first.
    template <typename Among>
    std::vector<int> component(int t, Among among) {
        const int round = ++round_;
        std::vector<int> found = {t};
        asked_[t] = round;
        for (std::size_t i = 0; i < found.size(); ++i) {
            for (const int other : beside(found[i])) {
                if (patch_[other] != none || asked_[other] == round || !among(other)) continue;
                asked_[other] = round;
                found.push_back(other);
            }
        }
        return found;
    }

    void group_around(int node) {
        const auto touches_node = [&](int t) {
            const Tetrahedron& nodes = mesh_.tetrahedra[t];
            return std::find(nodes.begin(), nodes.end(), node) != nodes.end();
        };
        for (const int t : stars_[node]) {
            if (patch_[t] != none) continue;
            std::vector<int> found = component(t, touches_node);
            if (found.size() < fewest) continue;
            const std::size_t parts = (found.size() + most - 1) / most;
            found.resize((found.size() + parts - 1) / parts);    // what is left comes up again
            close(found);
        }
    }

    void close(const std::vector<int>& tetrahedra) {
        for (const int t : tetrahedra) patch_[t] = static_cast<int>(sizes_.size());
        sizes_.push_back(tetrahedra.size());
    }

    void join_leftovers() {
        for (bool joined = true; joined;) {
            joined = false;
            for (const int t : order_) {
                if (patch_[t] != none) continue;
                int smallest = none;
                for (const int other : beside(t)) {
                    const int patch = patch_[other];
                    if (patch != none && (smallest == none || sizes_[patch] < sizes_[smallest])) smallest = patch;
                }
                if (smallest == none) continue;
                patch_[t] = smallest;
                ++sizes_[smallest];
                joined = true;
            }
        }
    }

    const Mesh& mesh_;
    std::vector<std::array<int, 4>> neighbours_;
    std::vector<int> node_order_, node_rank_;    // nodes by place
    std::vector<int> order_, rank_;              // tetrahedra by the places of their nodes
    std::vector<std::vector<int>> stars_;        // of each node, its tetrahedra in order
    std::vector<int> patch_;
    std::vector<std::size_t> sizes_;    // of the patches
    std::vector<int> asked_;            // of each tetrahedron, the last round of `component` that met it
    int round_ = 0;
};

}    // namespace

std::vector<int> patches_of(const Mesh& mesh) {
    return Grouping(mesh).run();
}

}    // namespace stylet::corotational_fem
