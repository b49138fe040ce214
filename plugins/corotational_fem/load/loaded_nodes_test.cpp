// Loads on patches of a mesh, as the tissue's users see them.
#include "load/loaded_nodes.h"

#include "mesh/meshes_for_tests.h"
#include "solid/test_solids.h"

#include <stylet/contract/contract.h>
#include <stylet/tissue_model.h>

#include <cstdio>

namespace stylet::corotational_fem {
namespace {

const Patch wide{.centre = {0.003, -0.002, 0.0}, .size = {0.047, 0.031, 0.0}};
const Patch narrow{.centre = {0.0191, 0.0077, 0.0}, .size = {0.0113, 0.0131, 0.0}};

contract::Case block_shared_by(const std::string& what) {
    contract::Case with{.name = "Block", .has_needle = false};
    with.tissue.extent = Vector3(0.1, 0.1, 0.05);
    with.tissue.layers[0].thickness = 0.05;
    with.parameters = {{"cells", Vector3(11.0, 9.0, 5.0)},
                       {"pressure", std::string("patch")},
                       {"dynamics", std::string("quasi_static")},
                       {"solver", std::string("newton")},
                       {"load_shared_by", what}};
    return with;
}

void settle(TissueModel& tissue, const Vector3& on_wide, const Vector3& on_narrow) {
    const Vector3 forces[] = {on_wide, on_narrow};
    tissue.load(forces);
    tissue.predict(1e-3);
    (void)tissue.try_step({}, {nullptr, 0});
    tissue.commit();
}

TEST(LoadedNodes, WorkAlongTheMeanDisplacementOfTheirPatch) {
    constexpr double small = 1e-4;     // of the work: what strains of the same size make of a linear tissue
    constexpr double little = 1e-3;    // [N]
    for (const std::string what : {"nodes", "area"}) {
        const contract::Case with = block_shared_by(what);
        const auto tissue = contract::make<TissueModel>(STYLET_PLUGIN_FILE, with);
        tissue->bear(std::vector<Patch>{wide, narrow});
        const Vector3 a = little * Vector3(0.2, 0.1, -1.0), b = little * Vector3(-0.1, 0.3, 0.7), none = Vector3::Zero();
        settle(*tissue, a, none);
        const double b_along_a = b.dot(tissue->patch_displacement(1)), stored = tissue->energy().stored;
        const double work = 0.5 * a.dot(tissue->patch_displacement(0));
        settle(*tissue, none, b);
        const double a_along_b = a.dot(tissue->patch_displacement(0));
        std::printf("%s: work over stored energy %.6f, one patch's work in the other's field over the reverse %.6f\n",
                    what.c_str(), work / stored, b_along_a / a_along_b);
        EXPECT_NEAR(work, stored, small * stored);
        EXPECT_NEAR(b_along_a, a_along_b, small * std::abs(a_along_b));
    }
}

TEST(LoadedNodes, HaveAllOfEachPatchsForce) {
    constexpr double rounding = 1e-12;
    const Mesh mesh = testing::block({0.1, 0.1, 0.05}, {11, 9, 5});
    const auto boundary = boundary_of(mesh, neighbours_of(mesh));
    const Vector3 forces[] = {{0.1, -0.2, -1.0}, {0.0, 0.5, 2.0}};
    for (const SharedBy what : {SharedBy::nodes, SharedBy::area}) {
        LoadedNodes loaded(what);
        loaded.place(std::vector<Patch>{wide, narrow}, mesh, boundary);
        Vector3 sum = Vector3::Zero();
        for (const NodeForce& each : loaded.share(forces)) sum += each.force;
        EXPECT_LE((sum - forces[0] - forces[1]).norm(), rounding);
    }
}

TEST(LoadedNodes, SayWhereTheNearestSurfaceIs) {
    const Mesh mesh = testing::block({0.1, 0.1, 0.05}, {2, 2, 2});
    const auto boundary = boundary_of(mesh, neighbours_of(mesh));
    const auto refused = [&](SharedBy what, const Vector3& centre) {
        LoadedNodes loaded(what);
        return refusal([&] { loaded.place(std::vector<Patch>{{.centre = centre, .size = {0.01, 0.01, 0.0}}}, mesh, boundary); });
    };
    EXPECT_EQ(refused(SharedBy::nodes, {0.03, 0.0, 0.0}),
              "found a patch without a node of the mesh's surface, wanted one that holds some: the nearest is 0.02 m from its "
              "centre");
    EXPECT_EQ(refused(SharedBy::area, {0.03, 0.0, 0.0}), "accepted");
    EXPECT_EQ(refused(SharedBy::area, {0.08, 0.0, 0.0}),
              "found a patch without area on the mesh's surface, wanted one that holds some: the nearest node is 0.03 m from its "
              "centre");
}

}    // namespace
}    // namespace stylet::corotational_fem
