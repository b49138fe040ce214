// A block for the fast solver's tests, and how core calls a solver.
#pragma once

#include "mesh/block_mesh.h"
#include "mesh/meshes_for_tests.h"
#include "solid/test_solids.h"
#include "solver.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace stylet::corotational_fem::testing {

inline const Forces no_forces(nullptr, 0);

inline Material gel_of(double poisson_ratio) {
    return elastic(25e3, poisson_ratio, 1000.0);
}

inline Motion falling(double dt) {
    return {.implicit = true, .gravity = Vector3(0, 0, -9.81), .dt = dt};
}

// A block of gel, 100 × 80 × 50 mm, held at the bottom.
struct Block {
    Mesh mesh = block_mesh(gel(), {6, 5, 4});
    std::vector<Material> materials{gel_of(0.49)};

    // The mean of some nodes near the middle of the top, and one by the edge.
    [[nodiscard]] std::vector<NodeWeight> footprint(int which) const {
        const int top = mesh.node_count() - 7 * 6;
        switch (which) {
            case 0:
                return {{top + 3 * 7 + 3, 0.5}, {top + 3 * 7 + 2, 0.3}, {top - 7 * 6 + 3 * 7 + 3, 0.2}};
            case 1:
                return {{top + 2 * 7 + 4, 1.0}};
            default:
                return {{top + 1, 0.6}, {5, 0.4}};    // partly held
        }
    }

    // Spread over the middle of the top.
    [[nodiscard]] std::vector<NodeForce> push(double force) const {
        std::vector<NodeForce> forces;
        for (int i = 0; i < mesh.node_count(); ++i) {
            const Vector3& at = mesh.nodes[i];
            if (at.z() > -1e-9 && at.head<2>().norm() < 0.02) forces.push_back({i, Vector3::Zero()});
        }
        for (NodeForce& each : forces) each.force = Vector3(0.1 * force, 0.0, -force) / static_cast<double>(forces.size());
        return forces;
    }
};

// Until it says that it is in balance.
inline void solve(Solver& solver, Forces forces = no_forces) {
    constexpr int most = 200;
    VectorX free(forces.size());
    MatrixX compliance(forces.size(), forces.size());
    for (int tries = 0; tries < most; ++tries) {
        solver.linearise(static_cast<int>(forces.size()) / 3, free, compliance);
        if (solver.try_step(forces).residual == 0.0) return;
    }
    FAIL() << "not in balance after " << most << " tries";
}

inline void step(Solver& solver, double dt, Forces forces = no_forces) {
    solver.predict(dt);
    solve(solver, forces);
    solver.commit();
}

inline double difference(const Mesh& mesh, const Solver& a, const Solver& b) {
    double apart = 0.0, all = 0.0;
    for (int i = 0; i < mesh.node_count(); ++i) {
        apart += (a.displacement(i) - b.displacement(i)).squaredNorm();
        all += b.displacement(i).squaredNorm();
    }
    return std::sqrt(apart / all);
}

}    // namespace stylet::corotational_fem::testing
