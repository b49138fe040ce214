#include <stylet/contract/contract.h>
#include <stylet/tissue_model.h>

#include <cstdio>
#include <limits>
#include <string>
#include <vector>

namespace stylet {
namespace {

using contract::Case;
using contract::Given;

Given given(const char* dynamics, const char* pressure) {
    return {{"cells", Vector3(4.0, 4.0, 3.0)},
            {"pressure", std::string(pressure)},
            {"dynamics", std::string(dynamics)},
            {"solver", std::string("newton")}};
}

Given fast(const char* dynamics, const char* pressure) {
    Given parameters = given(dynamics, pressure);
    parameters.set("solver", std::string("quasi_newton"));
    parameters.set("accuracy", 1e-4);
    return parameters;
}

Given damped() {
    Given parameters = given("implicit", "tetrahedron");
    parameters.set("damping_time", 0.001);
    return parameters;
}

Given fast_damped() {
    Given parameters = fast("implicit", "patch");
    parameters.set("damping_time", 0.01);
    return parameters;
}

TissueSetup two_layers() {
    TissueSetup tissue = contract::gel_block();
    tissue.layers.insert(tissue.layers.begin(), tissue.layers.front());
    tissue.layers.front().name = "skin";
    tissue.layers.front().youngs_modulus = 60e3;
    tissue.layers.front().thickness = 5e-3;
    tissue.layers.back().thickness -= 5e-3;
    return tissue;
}

// Newton's factor may be of an earlier state: under these loads it is off by less.
constexpr double older_tangent = 1e-2;

// The fast solver's compliance is always that of the undeformed mesh.
constexpr double undeformed_tangent = 5e-2;

// Loads that bend the mesh so far that Newton factorises anew, and so allocates, are left to the tests of the solver itself.
STYLET_CONTRACT(
    Case{.name = "AtRest", .parameters = given("quasi_static", "tetrahedron"), .steps = 16, .tangent = older_tangent},
    Case{.name = "Patches", .parameters = given("quasi_static", "patch"), .steps = 16, .tangent = older_tangent},
    Case{.name = "TwoLayers",
         .parameters = given("quasi_static", "patch"),
         .tissue = two_layers(),
         .load = 0.1,
         .steps = 16,
         .tangent = older_tangent},
    Case{.name = "Swinging", .parameters = given("implicit", "tetrahedron"), .load = 0.01, .steps = 16, .tangent = older_tangent},
    Case{.name = "Damped", .parameters = damped(), .load = 0.01, .steps = 16, .tangent = older_tangent},
    Case{.name = "Fast", .parameters = fast("quasi_static", "tetrahedron"), .tangent = undeformed_tangent},
    Case{.name = "FastPatches", .parameters = fast("quasi_static", "patch"), .tangent = undeformed_tangent},
    Case{.name = "FastTwoLayers",
         .parameters = fast("quasi_static", "patch"),
         .tissue = two_layers(),
         .tangent = undeformed_tangent},
    Case{.name = "FastSwinging", .parameters = fast("implicit", "tetrahedron"), .tangent = undeformed_tangent},
    Case{.name = "FastDamped", .parameters = fast_damped(), .tangent = undeformed_tangent})

class BothSolvers : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(CorotationalFem, BothSolvers, testing::Values("newton", "quasi_newton"),
                         [](const auto& solver) { return std::string(solver.param); });

TEST_P(BothSolvers, ForgetForcesThatAreNoNumbers) {
    Case with{.parameters = fast("quasi_static", "patch")};
    with.parameters.set("solver", std::string(GetParam()));
    const auto tissue = contract::make<TissueModel>(STYLET_PLUGIN_FILE, with);
    const std::vector<ContactPoint> points{{Vector3::Zero(), Vector3::Zero(), 0.2, true}};
    VectorX forces = VectorX::Zero(3);
    const auto answer = [&](double force) -> Vector3 {
        forces[2] = force;
        tissue->predict(with.dt);
        for (int i = 0; i < 20; ++i) {
            (void)tissue->linearise(points, 0.0);
            if (tissue->try_step(points, {forces.data(), 3}).residual <= 1e-9) break;
        }
        const Linearisation found = tissue->linearise(points, 0.0);
        return found.free + found.compliance * forces;
    };
    const Vector3 before = answer(-0.5);
    tissue->commit();
    for (const double force : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), 1e300}) {
        (void)answer(force);
        tissue->rollback();
        const Vector3 after = answer(-0.5);
        std::printf("%s, after a force of %g N: off by %.1e m\n", GetParam(), force, (after - before).norm());
        EXPECT_LE((after - before).norm(), 1e-4 * before.norm()) << force;    // the accuracy that it was asked for
        tissue->rollback();
    }
}

}    // namespace
}    // namespace stylet
