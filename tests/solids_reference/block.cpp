// block FOLDER POISSON_RATIO LOAD: the block of the speed goals under a small load, as an input file for CalculiX and as this
// project solves it: FOLDER/block.inp, and FOLDER/displacements.txt with the x, y and z of each node [m], in the order of its
// nodes there.
#include "mesh/block_mesh.h"
#include "solid/newton.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <string>

namespace stylet::corotational_fem {
namespace {

constexpr double youngs_modulus = 25e3, density = 1000.0;    // [Pa], [kg/m³]
constexpr double reach = 10.5e-3;                            // [m] of the patch at the middle of the top, along x and y
// A thousandth of the goals' newton and of gravity: strains of 1e-5, so that CalculiX's linear answer and ours differ by as
// little.
constexpr double force = 1e-3;              // [N]
constexpr double acceleration = 9.81e-3;    // [m/s²]
constexpr double step = 1.0;                // [s] of no consequence without inertia
constexpr int most_iterations = 20;

Mesh block() {
    const Layer gel{.name = "gel", .youngs_modulus = youngs_modulus, .poisson_ratio = 0.0, .density = density, .thickness = 0.05};
    return block_mesh({.extent = {0.1, 0.1, 0.05}, .fixed = "bottom", .layers = {gel}}, {11, 11, 7});
}

std::vector<NodeForce> patch_load(const Mesh& mesh) {
    std::vector<NodeForce> forces;
    for (int i = 0; i < mesh.node_count(); ++i) {
        const Vector3& x = mesh.nodes[i];
        if (x.z() > -1e-9 && std::abs(x.x()) <= reach && std::abs(x.y()) <= reach) forces.push_back({i, Vector3::Zero()});
    }
    for (NodeForce& each : forces) each.force.z() = -force / static_cast<double>(forces.size());
    return forces;
}

// CalculiX counts from one; its users' manual, version 2.20, describes the keywords.
void write_input(std::ostream& file, const Mesh& mesh, double poisson_ratio, const std::vector<NodeForce>& loads, bool weight) {
    file.precision(17);
    file << "*NODE, NSET=ALL\n";
    for (int i = 0; i < mesh.node_count(); ++i) {
        const Vector3& x = mesh.nodes[i];
        file << i + 1 << ", " << x.x() << ", " << x.y() << ", " << x.z() << '\n';
    }
    file << "*ELEMENT, TYPE=C3D4, ELSET=BLOCK\n";
    for (int e = 0; e < mesh.size(); ++e) {
        file << e + 1;
        for (const int node : mesh.tetrahedra[e]) file << ", " << node + 1;
        file << '\n';
    }
    file << "*BOUNDARY\n";
    for (int i = 0; i < mesh.node_count(); ++i) {
        if (mesh.fixed[i] != 0) file << i + 1 << ", 1, 3\n";
    }
    file << "*MATERIAL, NAME=GEL\n*ELASTIC\n" << youngs_modulus << ", " << poisson_ratio << "\n*DENSITY\n" << density << '\n';
    file << "*SOLID SECTION, ELSET=BLOCK, MATERIAL=GEL\n*STEP\n*STATIC\n";
    if (!loads.empty()) file << "*CLOAD\n";
    for (const NodeForce& load : loads) file << load.node + 1 << ", 3, " << load.force.z() << '\n';
    if (weight) file << "*DLOAD\nBLOCK, GRAV, " << acceleration << ", 0, 0, -1\n";
    file << "*NODE PRINT, NSET=ALL\nU\n*END STEP\n";
}

void write_displacements(std::ostream& file, const Mesh& mesh, double poisson_ratio, const std::vector<NodeForce>& loads,
                         bool weight) {
    const Material gel{.shear_modulus = youngs_modulus / (2.0 * (1.0 + poisson_ratio)),
                       .lame = youngs_modulus * poisson_ratio / ((1.0 + poisson_ratio) * (1.0 - 2.0 * poisson_ratio)),
                       .density = density};
    Newton newton(mesh, {&gel, 1}, {.gravity = {0.0, 0.0, weight ? -acceleration : 0.0}, .dt = step});
    newton.load(loads);
    newton.predict(step);
    VectorX free;
    MatrixX compliance;
    for (int i = 0;; ++i) {
        if (i == most_iterations) throw Error("found no balance in twenty iterations, wanted one in a few");
        newton.linearise(0, free, compliance);
        if (newton.try_step(Forces(nullptr, 0)).residual == 0.0) break;
    }
    file.precision(17);
    for (int i = 0; i < mesh.node_count(); ++i) file << newton.displacement(i).transpose() << '\n';
}

void solve(const std::filesystem::path& folder, double poisson_ratio, const std::string& load) {
    if (load != "patch" && load != "weight") throw Error("found load '" + load + "', wanted patch or weight");
    const bool weight = load == "weight";
    const Mesh mesh = block();
    const std::vector<NodeForce> loads = weight ? std::vector<NodeForce>{} : patch_load(mesh);
    std::ofstream input(folder / "block.inp"), displacements(folder / "displacements.txt");
    write_input(input, mesh, poisson_ratio, loads, weight);
    write_displacements(displacements, mesh, poisson_ratio, loads, weight);
    if (!input.flush() || !displacements.flush()) throw Error("found no way to write into " + folder.string());
}

}    // namespace
}    // namespace stylet::corotational_fem

int main(int count, char** arguments) try {
    if (count != 4) throw stylet::Error("wanted a folder, Poisson's ratio, and patch or weight");
    stylet::corotational_fem::solve(arguments[1], std::atof(arguments[2]), arguments[3]);
    return EXIT_SUCCESS;
} catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return EXIT_FAILURE;
}
