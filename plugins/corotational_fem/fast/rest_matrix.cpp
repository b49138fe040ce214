#include "fast/rest_matrix.h"

#include "mesh/mass.h"

#include <algorithm>
#include <array>

namespace stylet::corotational_fem {

namespace {

struct Shape {
    double volume;                       // [m³]
    std::array<Vector3, 4> gradients;    // [1/m] of each node's shape function
};

Shape shape(const Mesh& mesh, const Tetrahedron& nodes) {
    const Matrix3 edges = mesh.edges(nodes);
    const Matrix3 inverse = edges.inverse();
    Shape result{edges.determinant() / 6.0, {}};
    for (int i = 0; i < 3; ++i) result.gradients[i + 1] = inverse.row(i).transpose();
    result.gradients[0] = -(result.gradients[1] + result.gradients[2] + result.gradients[3]);
    return result;
}

// A few nodes and how fast the volume of what they span grows as each of them moves.
struct Volume {
    std::vector<int> nodes;
    std::vector<Vector3> growth;    // [m²]
    double volume = 0.0;            // [m³]
    double lame = 0.0;              // [Pa]

    void add(const Tetrahedron& tetrahedron, const Shape& s, double layer_lame) {
        for (int i = 0; i < 4; ++i) {
            const auto found = std::find(nodes.begin(), nodes.end(), tetrahedron[i]);
            const std::size_t at = found - nodes.begin();
            if (found == nodes.end()) {
                nodes.push_back(tetrahedron[i]);
                growth.emplace_back(Vector3::Zero());
            }
            growth[at] += s.volume * s.gradients[i];
        }
        volume += s.volume;
        lame = layer_lame;
    }
};

// What shares one pressure: the patches, or else each tetrahedron by itself.
std::vector<Volume> volumes(const Mesh& mesh, const std::vector<Shape>& shapes, std::span<const Material> materials,
                            bool shared) {
    std::vector<Volume> result(shared && mesh.size() > 0 ? 1 + *std::max_element(mesh.patches.begin(), mesh.patches.end())
                                                         : mesh.size());
    for (int e = 0; e < mesh.size(); ++e) {
        result[shared ? mesh.patches[e] : e].add(mesh.tetrahedra[e], shapes[e], materials[mesh.layers[e]].lame);
    }
    return result;
}

// Rows, and the columns of those that any volume ties together; all blocks zero.
BlockMatrix pattern(const Mesh& mesh, const std::vector<Volume>& groups) {
    BlockMatrix a;
    a.row.assign(mesh.node_count(), -1);
    for (int node = 0; node < mesh.node_count(); ++node) {
        if (mesh.fixed[node]) continue;
        a.row[node] = a.rows();
        a.mesh_node.push_back(node);
    }
    std::vector<std::vector<int>> columns(a.rows());
    for (const Volume& group : groups) {
        for (const int i : group.nodes) {
            if (a.row[i] < 0) continue;
            for (const int j : group.nodes) {
                if (a.row[j] >= 0) columns[a.row[i]].push_back(a.row[j]);
            }
        }
    }
    a.start.push_back(0);
    for (int row = 0; row < a.rows(); ++row) {
        std::vector<int>& mine = columns[row];
        mine.push_back(row);    // a node of no tetrahedron has a row too
        std::sort(mine.begin(), mine.end());
        mine.erase(std::unique(mine.begin(), mine.end()), mine.end());
        a.column.insert(a.column.end(), mine.begin(), mine.end());
        a.start.push_back(static_cast<int>(a.column.size()));
    }
    a.block.assign(a.column.size(), Matrix3::Zero());
    return a;
}

void add(BlockMatrix& a, int node_i, int node_j, const Matrix3& block) {
    const int i = a.row[node_i], j = a.row[node_j];
    if (i < 0 || j < 0) return;
    const auto begin = a.column.begin() + a.start[i], end = a.column.begin() + a.start[i + 1];
    a.block[std::lower_bound(begin, end, j) - a.column.begin()] += block;
}

void add_shear(BlockMatrix& a, const Tetrahedron& nodes, const Shape& s, double shear_modulus) {
    const double weight = s.volume * shear_modulus;
    for (int i = 0; i < 4; ++i) {
        for (int j = 0; j < 4; ++j) {
            const Vector3 &gi = s.gradients[i], &gj = s.gradients[j];
            add(a, nodes[i], nodes[j], weight * (gj * gi.transpose() + gi.dot(gj) * Matrix3::Identity()));
        }
    }
}

// The energy V λ/2 θ̄², θ̄ = Σ growth·u / V.
void add_pressure(BlockMatrix& a, const Volume& group) {
    const double weight = group.lame / group.volume;
    for (std::size_t i = 0; i < group.nodes.size(); ++i) {
        for (std::size_t j = 0; j < group.nodes.size(); ++j) {
            add(a, group.nodes[i], group.nodes[j], weight * group.growth[i] * group.growth[j].transpose());
        }
    }
}

}    // namespace

BlockMatrix rest_matrix(const Mesh& mesh, std::span<const Material> materials, const Motion& motion) {
    std::vector<Shape> shapes;
    shapes.reserve(mesh.tetrahedra.size());
    for (const Tetrahedron& tetrahedron : mesh.tetrahedra) shapes.push_back(shape(mesh, tetrahedron));
    const std::vector<Volume> groups = volumes(mesh, shapes, materials, motion.share_pressure);

    BlockMatrix a = pattern(mesh, groups);
    for (int e = 0; e < mesh.size(); ++e) add_shear(a, mesh.tetrahedra[e], shapes[e], materials[mesh.layers[e]].shear_modulus);
    for (const Volume& group : groups) {
        if (group.volume > 0.0) add_pressure(a, group);
    }
    if (motion.damping_time > 0.0) {
        for (Matrix3& block : a.block) block *= 1.0 + motion.damping_time / motion.dt;
    }
    if (!motion.implicit) return a;
    const VectorX mass = lumped_mass(mesh, materials);
    for (const int node : a.mesh_node) add(a, node, node, mass[node] / (motion.dt * motion.dt) * Matrix3::Identity());
    return a;
}

}    // namespace stylet::corotational_fem
