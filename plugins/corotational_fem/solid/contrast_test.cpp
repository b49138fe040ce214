// Hard cases 9 and 10: layers a million and a hundred million times as stiff as their neighbours.
#include "solid/newton_steps.h"

#include <gtest/gtest.h>

#include <cstdio>

namespace stylet::corotational_fem {
namespace {

using namespace testing;

constexpr double cell = 0.01;    // [m]

// Four cells high, the upper two of another layer.
Mesh two_layers(int across) {
    Mesh mesh = block(cell * Vector3(across, across, 4.0), {across, across, 4});
    for (int e = mesh.size() / 2; e < mesh.size(); ++e) mesh.layers[e] = 1;
    return mesh;
}

// The inner forces [N] of one layer alone.
VectorX pull_of(int layer, const Mesh& mesh, const std::vector<Material>& materials, const VectorX& u) {
    Mesh part = mesh;
    part.tetrahedra.clear();
    part.layers.clear();
    part.patches.clear();
    for (int e = 0; e < mesh.size(); ++e) {
        if (mesh.layers[e] != layer) continue;
        part.tetrahedra.push_back(mesh.tetrahedra[e]);
        part.layers.push_back(layer);
        part.patches.push_back(mesh.patches[e] - (layer == 0 ? 0 : mesh.patches[mesh.size() / 2]));
    }
    VectorX forces = VectorX::Zero(u.size());
    Solid(part, materials, true).strain(u, forces);
    return forces;
}

// A solved mesh whose layers' forces are then added up apart from the solver.
struct Solved {
    Solved(const Mesh& mesh, const std::vector<Material>& materials, const VectorX& forces) : u(forces.size()) {
        Steps steps(mesh, materials, {.share_pressure = true, .dt = 1.0});
        steps.load(forces);
        iterations = steps.step(1.0);
        u = steps.displacements();
        below = pull_of(0, mesh, materials, u);
        const VectorX lacking = below + pull_of(1, mesh, materials, u) - forces;
        for (int i = 0; i < mesh.node_count(); ++i) {
            const bool at_interface = std::abs(mesh.nodes[i].z() + 2.0 * cell) < 1e-9;
            if (mesh.fixed[i] == 0) residual = std::max(residual, lacking.segment<3>(3 * i).norm());
            if (at_interface) crossing += below.segment<3>(3 * i);
        }
    }
    VectorX u, below;    // [m], [N] inner forces of the lower layer
    int iterations;
    double residual = 0.0;                 // [N] at a node, the interface's included
    Vector3 crossing = Vector3::Zero();    // [N] from the upper layer to the lower one
};

constexpr double balanced = 1e-6;    // of the load: hard case 9

TEST(StiffnessContrast, OfAMillionLeavesTheInterfaceInBalance) {
    const Mesh mesh = two_layers(4);
    for (const bool stiff_on_top : {true, false}) {
        const Material soft = elastic(25e3, 0.45), stiff = elastic(25e9, 0.3);
        const std::vector<Material> materials =
            stiff_on_top ? std::vector<Material>{soft, stiff} : std::vector<Material>{stiff, soft};
        const Vector3 force(0.1, 0.0, -1.0);    // [N]
        VectorX forces = VectorX::Zero(3 * mesh.node_count());
        for (int i = mesh.node_count() - 25; i < mesh.node_count(); ++i) forces.segment<3>(3 * i) = force / 25.0;
        const Solved solved(mesh, materials, forces);
        const double lacking = (solved.crossing - force).norm() / force.norm();
        std::printf(
            "stiff layer %s: %d iterations, residual %.1e of the load, what crosses the interface is off by %.1e; sinks by %.3f "
            "mm\n",
            stiff_on_top ? "above" : "below", solved.iterations, solved.residual / force.norm(), lacking,
            -1e3 * solved.u[solved.u.size() - 1]);
        EXPECT_GT(solved.iterations, 0);
        EXPECT_LE(solved.residual, balanced * force.norm());
        EXPECT_LE(lacking, balanced * mesh.node_count()) << "at most each node's part";
    }
}

// Steel on tissue of 1 kPa, without Poisson's effect, so that springs in series are the exact answer.
TEST(StiffnessContrast, OfSteelOnTissueSinksAsSpringsInSeriesDo) {
    constexpr double tissue = 1e3, steel = 2e11, strain = 0.05;    // [Pa], [Pa], 1 of the tissue
    constexpr double exact = 1e-6;    // hard case 10 asks for 0.01; the forces are balanced to so much
    const Mesh mesh = two_layers(1);
    const double force = tissue * strain * cell * cell;                     // [N]
    const double share[] = {1.0 / 3.0, 1.0 / 6.0, 1.0 / 6.0, 1.0 / 3.0};    // of the top's two triangles
    VectorX forces = VectorX::Zero(3 * mesh.node_count());
    for (int i = 0; i < 4; ++i) forces[3 * (mesh.node_count() - 4 + i) + 2] = -share[i] * force;
    const Solved solved(mesh, {elastic(tissue, 0.0), elastic(steel, 0.0)}, forces);
    const double expected = force * 2.0 * cell / (cell * cell) * (1.0 / tissue + 1.0 / steel);    // [m]
    const double found = -solved.u[solved.u.size() - 1];
    std::printf("steel on tissue: %d iterations, residual %.1e of the load, tip sinks by %.9f of %.9f mm\n", solved.iterations,
                solved.residual / force, 1e3 * found, 1e3 * expected);
    EXPECT_GT(solved.iterations, 0);
    EXPECT_LE(solved.residual, 1e-5 * force) << "the last place of a strain of steel is 4e-9 N here";
    EXPECT_NEAR(found, expected, exact * expected);
}

}    // namespace
}    // namespace stylet::corotational_fem
