#include "mesh/block_mesh.h"

#include "mesh/complaints.h"
#include "mesh/held.h"
#include "mesh/mesh_checks.h"

#include <algorithm>
#include <string>

namespace stylet::corotational_fem {
namespace {

using Cells = std::array<int, 3>;

constexpr double most_cells = 1e6;    // six million tetrahedra: far more than any tick could move

void refuse_counts(const Cells& cells, const TissueSetup& tissue) {
    const auto [nx, ny, nz] = cells;
    const std::size_t layers = tissue.layers.size();
    const std::string found = "found " + std::to_string(nx) + " x " + std::to_string(ny) + " x " + std::to_string(nz) + " cells";
    if (std::min({nx, ny, nz}) < 1) throw Error("cells", found + ", wanted at least one along each axis");
    if (static_cast<double>(nx) * ny * nz > most_cells) throw Error("cells", found + ", wanted at most 1000000 in all");
    if (holds_sides(tissue) && std::min(nx, ny) == 1) {
        throw Error("cells", found + ", all of whose nodes are on the sides, which are held, wanted two at least along x and y");
    }
    if (static_cast<std::size_t>(nz) < layers) {
        throw Error("cells", "found " + std::to_string(nz) + " along z for " + std::to_string(layers) +
                                 " layers, wanted at least one cell through each layer");
    }
}

/// Where the planes of nodes lie, from the top.
struct Planes {
    std::vector<double> z;      // [m] nz + 1
    std::vector<int> layers;    // nz, of what lies below each
};

Planes planes_of(const TissueSetup& tissue, int nz) {
    const std::size_t count = tissue.layers.size();
    std::vector<double> borders = {0.0};    // [m] depths
    for (std::size_t i = 0; i + 1 < count; ++i) borders.push_back(borders.back() + tissue.layers[i].thickness);
    borders.push_back(tissue.extent.z());

    std::vector<int> shares(count, 1);
    const auto cell_height = [&](std::size_t i) { return (borders[i + 1] - borders[i]) / shares[i]; };
    for (int spare = nz - static_cast<int>(count); spare > 0; --spare) {
        std::size_t thickest = 0;
        for (std::size_t i = 1; i < count; ++i) {
            if (cell_height(i) > cell_height(thickest)) thickest = i;
        }
        ++shares[thickest];
    }

    Planes planes;
    for (std::size_t i = 0; i < count; ++i) {
        for (int k = 0; k < shares[i]; ++k) {
            planes.z.push_back(0.0 - (borders[i] + (borders[i + 1] - borders[i]) * k / shares[i]));
            planes.layers.push_back(static_cast<int>(i));
        }
    }
    planes.z.push_back(-tissue.extent.z());
    return planes;
}

/// The same numbers on either side of the middle, and half the width exactly at the ends.
double centred(double width, int i, int count) {
    return width * ((2 * i - count) / (2.0 * count));
}

/// The corners of a cell along each of its six tetrahedra, x + 2y + 4z; odd orders of the axes have two of them swapped, so
/// that every tetrahedron is right-handed.
constexpr std::array<std::array<int, 4>, 6> kuhn = {{
    {0, 1, 3, 7},    // x, y, z
    {0, 2, 6, 7},    // y, z, x
    {0, 4, 5, 7},    // z, x, y
    {0, 3, 2, 7},    // y, x, z
    {0, 6, 4, 7},    // z, y, x
    {0, 5, 1, 7},    // x, z, y
}};

/// Looks at one cell of each level: those beside it are alike.
void refuse_slivers(const Mesh& mesh, const TissueSetup& tissue, int cells_in_level) {
    const std::size_t step = kuhn.size() * cells_in_level;
    for (std::size_t first = 0; first < mesh.tetrahedra.size(); first += step) {
        for (std::size_t t = first; t < first + kuhn.size(); ++t) {
            const Tetrahedron& nodes = mesh.tetrahedra[t];
            if (!is_sliver(mesh, nodes)) continue;
            const Vector3 size = mesh.nodes[nodes[3]] - mesh.nodes[nodes[0]];
            throw Error("cells", "found cells of " + figure(size.x()) + " x " + figure(size.y()) + " x " + figure(size.z()) +
                                     " m in the layer \"" + tissue.layers[mesh.layers[t]].name +
                                     "\", whose tetrahedra are slivers, wanted cells of more even sides");
        }
    }
}

}    // namespace

Mesh block_mesh(const TissueSetup& tissue, const Cells& cells) {
    refuse_counts(cells, tissue);
    const auto [nx, ny, nz] = cells;
    const Planes planes = planes_of(tissue, nz);
    const std::array<int, 3> strides = {1, nx + 1, (nx + 1) * (ny + 1)};

    Mesh mesh;
    for (int k = 0; k <= nz; ++k) {
        for (int j = 0; j <= ny; ++j) {
            for (int i = 0; i <= nx; ++i) {
                mesh.nodes.emplace_back(centred(tissue.extent.x(), i, nx), centred(tissue.extent.y(), j, ny), planes.z[nz - k]);
                const bool at_side = i == 0 || i == nx || j == 0 || j == ny;
                mesh.fixed.push_back((holds_bottom(tissue) && k == 0) || (holds_sides(tissue) && at_side));
            }
        }
    }
    for (int cell = 0; cell < nx * ny * nz; ++cell) {
        const int i = cell % nx, j = cell / nx % ny, k = cell / nx / ny;
        const int least = i * strides[0] + j * strides[1] + k * strides[2];
        const auto node = [&](int corner) {
            return least + (corner & 1) * strides[0] + (corner >> 1 & 1) * strides[1] + (corner >> 2) * strides[2];
        };
        for (const auto& [a, b, c, d] : kuhn) mesh.tetrahedra.push_back({node(a), node(b), node(c), node(d)});
        mesh.layers.insert(mesh.layers.end(), kuhn.size(), planes.layers[nz - 1 - k]);
        mesh.patches.insert(mesh.patches.end(), kuhn.size(), cell);
    }
    refuse_slivers(mesh, tissue, nx * ny);
    return mesh;
}

}    // namespace stylet::corotational_fem
