#pragma once

#include "mesh/mesh.h"

#include <stylet/setup.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <random>

namespace stylet::corotational_fem {

/// A tissue whose layers have these names and thicknesses [m].
inline TissueSetup tissue_of(const Vector3& extent, const std::vector<std::pair<std::string, double>>& layers) {
    TissueSetup tissue{.extent = extent, .fixed = "bottom", .layers = {}};
    for (const auto& [name, thickness] : layers) {
        tissue.layers.push_back({.name = name,
                                 .youngs_modulus = 25e3,
                                 .poisson_ratio = 0.45,
                                 .density = std::numeric_limits<double>::quiet_NaN(),
                                 .thickness = thickness});
    }
    return tissue;
}

inline TissueSetup gel() {
    return tissue_of(Vector3(0.1, 0.08, 0.05), {{"gel", 0.05}});
}

inline TissueSetup skin_and_muscle() {
    return tissue_of(Vector3(0.04, 0.03, 0.024), {{"skin", 0.008}, {"muscle", 0.016}});
}

inline double volume_of(const Mesh& mesh, const Tetrahedron& nodes) {
    const Vector3& origin = mesh.nodes[nodes[0]];
    return (mesh.nodes[nodes[1]] - origin).cross(mesh.nodes[nodes[2]] - origin).dot(mesh.nodes[nodes[3]] - origin) / 6.0;
}

/// [m³] of what is in a layer.
inline double volume_of_layer(const Mesh& mesh, int layer) {
    double sum = 0.0;
    for (int t = 0; t < mesh.size(); ++t) sum += mesh.layers[t] == layer ? volume_of(mesh, mesh.tetrahedra[t]) : 0.0;
    return sum;
}

/// The same mesh with its nodes, its tetrahedra and, evenly, each tetrahedron's nodes in another order.
struct Renumbered {
    Mesh mesh;
    std::vector<int> old_node;           // of each new one
    std::vector<int> old_tetrahedron;    // of each new one
};

inline Renumbered renumbered(const Mesh& mesh, unsigned seed) {
    std::mt19937 random(seed);
    Renumbered with{
        .mesh = {}, .old_node = std::vector<int>(mesh.nodes.size()), .old_tetrahedron = std::vector<int>(mesh.tetrahedra.size())};
    std::iota(with.old_node.begin(), with.old_node.end(), 0);
    std::iota(with.old_tetrahedron.begin(), with.old_tetrahedron.end(), 0);
    std::shuffle(with.old_node.begin(), with.old_node.end(), random);
    std::shuffle(with.old_tetrahedron.begin(), with.old_tetrahedron.end(), random);
    std::vector<int> new_node(mesh.nodes.size());
    for (int n = 0; n < mesh.node_count(); ++n) {
        new_node[with.old_node[n]] = n;
        with.mesh.nodes.push_back(mesh.nodes[with.old_node[n]]);
        with.mesh.fixed.push_back(mesh.fixed[with.old_node[n]]);
    }
    for (const int t : with.old_tetrahedron) {
        Tetrahedron nodes = mesh.tetrahedra[t];
        std::transform(nodes.begin(), nodes.end(), nodes.begin(), [&](int n) { return new_node[n]; });
        std::rotate(nodes.begin(), nodes.begin() + random() % 3, nodes.begin() + 3);
        with.mesh.tetrahedra.push_back(nodes);
        with.mesh.layers.push_back(mesh.layers[t]);
        with.mesh.patches.push_back(mesh.patches[t]);
    }
    return with;
}

/// What an action is refused with.
template <typename Action>
std::string refusal(Action action) {
    try {
        action();
    } catch (const Error& error) {
        return error.what();
    }
    return "accepted";
}

}    // namespace stylet::corotational_fem
