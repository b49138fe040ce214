#include "mesh/mass.h"

#include <stylet/error.h>

namespace stylet::corotational_fem {

VectorX lumped_mass(const Mesh& mesh, std::span<const Material> materials) {
    VectorX mass = VectorX::Zero(mesh.node_count());
    for (int e = 0; e < mesh.size(); ++e) {
        const double density = materials[mesh.layers[e]].density;
        if (!(density > 0.0))
            throw Error("layers", "found a layer without `density`, wanted one: this scene's tissue has weight or inertia");
        for (const int node : mesh.tetrahedra[e]) mass[node] += 0.25 * density * mesh.volume(mesh.tetrahedra[e]);
    }
    return mass;
}

}    // namespace stylet::corotational_fem
