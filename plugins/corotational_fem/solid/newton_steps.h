// Newton's class as Coupling drives it, for tests.
#pragma once

#include "mesh/mass.h"
#include "solid/newton.h"
#include "solid/test_solids.h"

#include <span>
#include <utility>
#include <vector>

namespace stylet::corotational_fem::testing {

/// Owns the mesh and the material, which a solver only refers to, and takes whole steps.
class Steps {
public:
    Steps(Mesh mesh, std::vector<Material> materials, const Motion& motion)
        : mesh_(std::move(mesh)),
          materials_(std::move(materials)),
          solid_(mesh_, materials_, motion.share_pressure),
          newton_(mesh_, materials_, motion) {}

    [[nodiscard]] const Mesh& mesh() const { return mesh_; }
    Newton& newton() { return newton_; }

    void load(const VectorX& forces) {
        std::vector<NodeForce> list;
        for (int i = 0; i < mesh_.node_count(); ++i) list.push_back({i, forces.segment<3>(3 * i)});
        newton_.load(list);
    }

    /// To the end of a step with these forces on the contacts. Returns how many iterations that took, −1: it did not get there.
    int solve(double dt, const VectorX& contact_forces = VectorX()) {
        newton_.predict(dt);
        const auto contacts = static_cast<int>(contact_forces.size()) / 3;
        VectorX free(contact_forces.size());
        MatrixX compliance(contact_forces.size(), contact_forces.size());
        for (int i = 1; i <= most_iterations; ++i) {
            newton_.linearise(contacts, free, compliance);
            residual_ = newton_.try_step(Forces(contact_forces.data(), contact_forces.size())).residual;
            if (residual_ == 0.0) return i;
        }
        return -1;
    }

    int step(double dt, const VectorX& contact_forces = VectorX()) {
        const int iterations = solve(dt, contact_forces);
        newton_.commit();
        return iterations;
    }

    [[nodiscard]] double residual() const { return residual_; }    // [N] of the last iteration

    [[nodiscard]] VectorX displacements() const {
        VectorX u(3 * mesh_.node_count());
        for (int i = 0; i < mesh_.node_count(); ++i) u.segment<3>(3 * i) = newton_.displacement(i);
        return u;
    }

    /// Moves a body at rest so that its nodes are at u [m], at rest again: two steps whose loads are what that takes, short ones,
    /// in which inertia outweighs whatever the solid does, so that there is only one answer. Then the loads end. Held nodes must
    /// be where they are in u. Needs `implicit`, no weight and no damping.
    void put(const VectorX& u, double dt) {
        const VectorX from = displacements(), mass = lumped_mass(mesh_, materials_);
        for (const VectorX& coasting : {from, VectorX(2.0 * u - from)}) {
            VectorX forces = VectorX::Zero(u.size());
            solid_.strain(u, forces);
            for (int i = 0; i < mesh_.node_count(); ++i) {
                forces.segment<3>(3 * i) += mass[i] / (dt * dt) * (u - coasting).segment<3>(3 * i);
            }
            load(forces);
            (void)step(dt);
        }
        newton_.load({});
    }

private:
    static constexpr int most_iterations = 1000;

    Mesh mesh_;
    std::vector<Material> materials_;
    Solid solid_;
    Newton newton_;
    double residual_ = 0.0;
};

}    // namespace stylet::corotational_fem::testing
