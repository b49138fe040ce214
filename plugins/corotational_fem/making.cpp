#include "making.h"

#include "fast/quasi_newton.h"
#include "mesh/block_mesh.h"
#include "mesh/gmsh_file.h"
#include "solid/newton.h"

#include <cmath>
#include <sstream>

namespace stylet::corotational_fem {

namespace {

std::array<int, 3> cells_of(const Parameters& parameters) {
    constexpr double most = 1000.0;    // along an axis
    std::array<int, 3> cells{};
    for (int i = 0; i < 3; ++i) {
        const double value = parameters.vector3("cells")[i];
        if (!(value >= 1.0 && value <= most && value == std::floor(value))) {
            std::ostringstream text;
            text << "found " << value << " cells, wanted whole numbers from 1 to 1000 along x, y and z";
            throw Error("cells", text.str());
        }
        cells[i] = static_cast<int>(value);
    }
    return cells;
}

// A key that says something about another one, which the scene leaves out.
void refuse_without(const Parameters& parameters, const char* key, const char* other) {
    if (!parameters.has(key) || parameters.has(other)) return;
    throw Error(key, "found `" + std::string(key) + "` without `" + other + "`, wanted both or neither");
}

Motion motion_of(const Setup& setup) {
    const Parameters& parameters = setup.parameters;
    return {.implicit = parameters.text("dynamics") == "implicit",
            .gravity = parameters.has("gravity") ? parameters.vector3("gravity") : Vector3(Vector3::Zero()),
            .damping_time = parameters.has("damping_time") ? parameters.number("damping_time") : 0.0,
            .share_pressure = parameters.text("pressure") == "patch",
            .dt = setup.dt};
}

}    // namespace

Mesh mesh_of(const Setup& setup) {
    const Parameters& parameters = setup.parameters;
    if (parameters.has("cells") == parameters.has("mesh")) {
        throw Error(parameters.has("mesh") ? "mesh" : "",
                    "found " + std::string(parameters.has("mesh") ? "both" : "neither") +
                        " of `cells` and `mesh`, wanted one: the block cut into cells, or a file");
    }
    refuse_without(parameters, "mesh_unit", "mesh");
    refuse_without(parameters, "mesh", "mesh_unit");
    refuse_without(parameters, "held", "mesh");
    if (parameters.has("cells")) return block_mesh(*setup.tissue, cells_of(parameters));
    const std::string held = parameters.has("held") ? parameters.text("held") : "";
    return read_gmsh_file(parameters.text("mesh"), parameters.number("mesh_unit"), *setup.tissue, held).mesh;
}

std::vector<Material> materials_of(const TissueSetup& tissue) {
    std::vector<Material> materials;
    for (const Layer& layer : tissue.layers) {
        const double modulus = layer.youngs_modulus, nu = layer.poisson_ratio;
        materials.push_back({.shear_modulus = modulus / (2.0 * (1.0 + nu)),
                             .lame = modulus * nu / ((1.0 + nu) * (1.0 - 2.0 * nu)),
                             .density = layer.density});
    }
    return materials;
}

std::unique_ptr<Solver> solver_of(const Setup& setup, const Mesh& mesh, std::span<const Material> materials) {
    const Parameters& parameters = setup.parameters;
    const Motion motion = motion_of(setup);
    if (parameters.text("solver") == "newton") return std::make_unique<Newton>(mesh, materials, motion);
    if (!parameters.has("accuracy")) {
        throw Error("accuracy", "found nothing, wanted how far quasi_newton may be off, such as 0.001, or `solver: newton`");
    }
    return std::make_unique<QuasiNewton>(mesh, materials, motion, parameters.number("accuracy"), setup.workers);
}

}    // namespace stylet::corotational_fem
