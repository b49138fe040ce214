#include <stylet/contract/contract.h>

#include <cmath>

namespace stylet {
namespace {

using contract::Case;

STYLET_CONTRACT(Case{.name = "Steel"}, Case{.name = "HardPush", .load = 8.0, .lateral = 0.5})

const Case plain;

constexpr double rounding = 1e-15;    // [m], [N], [N·m] of values below one

/// A needle pointing to −y, its base 0.2 m from the surface point.
Pose sideways() {
    return {Vector3(0.0, 0.2, 0.0), Quaternion(Eigen::AngleAxisd(-M_PI / 2.0, Vector3::UnitX()))};
}

TEST(Rigid, PointsLieOnTheLineFromTheBase) {
    const auto needle = contract::make<NeedleModel>(STYLET_PLUGIN_FILE, plain);
    needle->predict(sideways(), 0.2, 1e-3);
    EXPECT_LE((needle->position(0.05) - Vector3(0.0, 0.15, 0.0)).norm(), rounding);
    EXPECT_LE((needle->position(0.2) - Vector3::Zero()).norm(), rounding);
    EXPECT_LE((needle->tangent(0.1) - Vector3(0.0, -1.0, 0.0)).norm(), rounding);
}

TEST(Rigid, ForcesMoveNothing) {
    const auto needle = contract::make<NeedleModel>(STYLET_PLUGIN_FILE, plain);
    const ContactPoint tip{Vector3::Zero(), Vector3::Zero(), 0.2, true};
    const VectorX force = VectorX::Constant(3, 1.0);
    needle->predict(sideways(), 0.2, 1e-3);
    const StepReport report = needle->try_step({&tip, 1}, {force.data(), 3});
    const Linearisation found = needle->linearise({&tip, 1}, 0.0);
    EXPECT_EQ(report.residual, 0.0);
    EXPECT_FALSE(report.tangent_changed);
    EXPECT_EQ(found.negatives, 0);
    EXPECT_EQ(MatrixX(found.compliance), MatrixX::Zero(3, 3));
    EXPECT_LE(found.free.norm(), rounding);
}

TEST(Rigid, TheHandFeelsForceAndLever) {
    const auto needle = contract::make<NeedleModel>(STYLET_PLUGIN_FILE, plain);
    const ContactPoint tip{Vector3::Zero(), Vector3::Zero(), 0.2, true};
    const VectorX force = (VectorX(3) << 0.1, 2.0, 0.0).finished();    // +y pushes against the insertion
    needle->predict(sideways(), 0.2, 1e-3);
    (void)needle->try_step({&tip, 1}, {force.data(), 3});
    EXPECT_EQ(needle->base_wrench().force, Vector3::Zero()) << "not committed yet";
    needle->commit();
    EXPECT_LE((needle->base_wrench().force - Vector3(-0.1, -2.0, 0.0)).norm(), rounding);
    EXPECT_LE((needle->base_wrench().moment - Vector3(0.0, 0.0, -0.02)).norm(), rounding);    // −(0, −0.2, 0) × (0.1, 2, 0)
    EXPECT_NEAR(needle->state().axial_load, 2.0, rounding);
    EXPECT_TRUE(std::isinf(needle->state().critical_load));
}

}    // namespace
}    // namespace stylet
