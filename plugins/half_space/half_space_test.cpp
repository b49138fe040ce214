#include <stylet/contract/contract.h>
#include <stylet/mindlin_kernel.h>
#include <stylet/tissue_model.h>

#include <cmath>
#include <cstdio>
#include <limits>
#include <numbers>
#include <random>

namespace stylet {
namespace {

using contract::Case;
using Kernel = MindlinKernel;
using std::numbers::pi;

TissueSetup two_layers() {
    TissueSetup tissue = contract::gel_block();
    tissue.layers.insert(tissue.layers.begin(), {.name = "skin",
                                                 .youngs_modulus = 60e3,
                                                 .poisson_ratio = tissue.layers.front().poisson_ratio,
                                                 .density = std::numeric_limits<double>::quiet_NaN(),
                                                 .thickness = 5e-3});
    return tissue;
}

STYLET_CONTRACT(Case{.name = "Gel"}, Case{.name = "HardPush", .load = 2.0, .lateral = 0.3},
                Case{.name = "TwoLayers", .tissue = two_layers()})

constexpr double radius = 0.3e-3;     // [m]
constexpr double rounding = 1e-13;    // relative: a dozen operations
const Vector3 surface = Vector3::Zero();

double shear_modulus(double nu) {
    return 1.0 / (2.0 * (1.0 + nu));
}    // of E = 1

class HalfSpaceKernel : public testing::TestWithParam<double> {};
INSTANTIATE_TEST_SUITE_P(PoissonRatios, HalfSpaceKernel, testing::Values(0.0, 0.3, 0.49));

TEST_P(HalfSpaceKernel, OnTheSurfaceIsTheRigidPunch) {
    const double nu = GetParam(), G = shear_modulus(nu);
    const Matrix3 u = Kernel(nu, radius)(surface, surface);
    const double axial = (1.0 - nu * nu) / (2.0 * radius), lateral = (2.0 - nu) / (8.0 * G * radius);
    EXPECT_NEAR(u(2, 2) / axial, 1.0, rounding);
    EXPECT_NEAR(u(0, 0) / lateral, 1.0, rounding);
    EXPECT_NEAR(u(1, 1) / lateral, 1.0, rounding);
}

TEST_P(HalfSpaceKernel, DeepInsideIsSelvaduraisEmbeddedDisc) {
    const double nu = GetParam(), G = shear_modulus(nu);
    const Vector3 deep(0.0, 0.0, -100.0 * radius);
    const double disc = (3.0 - 4.0 * nu) / (32.0 * G * (1.0 - nu) * radius);
    // The surface's share falls with a/c; at a hundred radii it is below one per cent.
    constexpr double of_the_surface = 1e-2;
    const double ratio = Kernel(nu, radius)(deep, deep)(2, 2) / disc;
    std::printf("embedded disc, nu %.2f: %.5f of Selvadurai's\n", nu, ratio);
    EXPECT_NEAR(ratio, 1.0, of_the_surface);
}

TEST_P(HalfSpaceKernel, FarAwayIsBoussinesqAndKelvin) {
    const double nu = GetParam(), G = shear_modulus(nu);
    const Kernel kernel(nu, radius);
    const double r = 5e-3;
    // The blur b = 2a/π moves the source by b at right angles to the way: O(b²/r²) on the surface, O(b/r) along the axis.
    const double b = 2.0 * radius / pi;
    EXPECT_NEAR(kernel({r, 0.0, 0.0}, surface)(2, 2) * pi * r / (1.0 - nu * nu), 1.0, b * b / (r * r));
    const Vector3 source(0.0, 0.0, -1.0), below(0.0, 0.0, -1.0 - r);
    const double kelvin = 4.0 * (1.0 - nu) / (16.0 * pi * G * (1.0 - nu) * r);
    EXPECT_NEAR(kernel(below, source)(2, 2) / kelvin, 1.0, 2.0 * b / r);
}

// Stress at x for a unit force j at the source, by central differences.
Matrix3 stress(const Kernel& kernel, double nu, const Vector3& x, const Vector3& source, int j) {
    constexpr double h = 1e-7;
    const double G = shear_modulus(nu), lame = 2.0 * G * nu / (1.0 - 2.0 * nu);
    Matrix3 gradient;
    for (int i = 0; i < 3; ++i) {
        const Vector3 step = h * Vector3::Unit(i);
        gradient.col(i) = (kernel(x + step, source).col(j) - kernel(x - step, source).col(j)) / (2.0 * h);
    }
    return G * (gradient + gradient.transpose()) + lame * gradient.trace() * Matrix3::Identity();
}

TEST_P(HalfSpaceKernel, IsInEquilibriumAwayFromTheSource) {
    const double nu = GetParam(), h = 2e-6;
    const Kernel kernel(nu, radius);
    const Vector3 source(0.1e-3, 0.2e-3, -1e-3), x(0.9e-3, -0.5e-3, -0.6e-3);
    for (int j = 0; j < 3; ++j) {
        Vector3 divergence = Vector3::Zero();
        for (int i = 0; i < 3; ++i) {
            const Vector3 step = h * Vector3::Unit(i);
            divergence += (stress(kernel, nu, x + step, source, j) - stress(kernel, nu, x - step, source, j)).col(i) / (2.0 * h);
        }
        const double scale = stress(kernel, nu, x, source, j).norm() / 1e-3;    // a stress over the distance to the source
        // Two nested central differences: (h/r)² ≈ 4e-6 of truncation and 1e-16/(1e-7·2e-6)·r² ≈ 1e-4 of rounding.
        constexpr double differences = 1e-3;
        EXPECT_LE(divergence.norm(), differences * scale) << "force " << j;
    }
}

TEST_P(HalfSpaceKernel, LeavesTheSurfaceFree) {
    const double nu = GetParam();
    const Kernel kernel(nu, radius);
    const Vector3 source(0.0, 0.0, -1e-3);
    for (int j = 0; j < 3; ++j) {
        // A point must be inside for its differences: its traction falls linearly to zero with the depth.
        const double at_1 = stress(kernel, nu, {0.7e-3, 0.4e-3, -1e-6}, source, j).col(2).norm();
        const double at_10 = stress(kernel, nu, {0.7e-3, 0.4e-3, -1e-5}, source, j).col(2).norm();
        const double inside = stress(kernel, nu, {0.7e-3, 0.4e-3, -1e-3}, source, j).norm();
        EXPECT_LE(at_1, 1e-2 * inside) << "force " << j;
        EXPECT_LE(at_1, 0.15 * at_10 + 1e-6 * inside) << "force " << j;
    }
}

TEST_P(HalfSpaceKernel, VerticalShortcutIsTheSameFunction) {
    const Kernel kernel(GetParam(), radius);
    for (const double z : {0.0, -1e-3, -7e-3}) {
        for (const double c : {0.0, -1e-3, -20e-3}) {
            const Matrix3 on = kernel({0.0, 0.0, z}, {0.0, 0.0, c}), beside = kernel({1e-10, 0.0, z}, {0.0, 0.0, c});
            // Moving the point aside by x changes u by O(x/R), R at least the blur.
            EXPECT_LE((on - beside).norm(), 1e-6 * on.norm());
        }
    }
}

TEST_P(HalfSpaceKernel, IsReciprocalAndPositiveDefinite) {
    const Kernel kernel(GetParam(), radius);
    std::mt19937 random(7);
    std::uniform_real_distribution<double> across(-5e-3, 5e-3), down(-10e-3, 0.0);
    constexpr int count = 30;
    std::vector<Vector3> points;
    for (int i = 0; i < count; ++i) points.emplace_back(across(random), across(random), down(random));
    MatrixX all(3 * count, 3 * count);
    for (int i = 0; i < count; ++i) {
        for (int j = 0; j < count; ++j) all.block<3, 3>(3 * i, 3 * j) = kernel(points[i], points[j]);
    }
    EXPECT_LE((all - all.transpose()).norm(), rounding * all.norm());
    const VectorX eigenvalues = all.selfadjointView<Eigen::Lower>().eigenvalues();
    std::printf("30 random points, nu %.2f: eigenvalues from %.3g to %.3g m/N per 1/Pa\n", GetParam(), eigenvalues.minCoeff(),
                eigenvalues.maxCoeff());
    EXPECT_GT(eigenvalues.minCoeff(), 0.0);
}

TEST(HalfSpace, CaseStudyPunchIsTwentyNewtonsAMetre) {
    const double E = 25e3, nu = 0.49;
    const double stiffness = E / Kernel(nu, radius)(surface, surface)(2, 2);
    std::printf("case study: %.3f N/m axial, %.3f N/m lateral\n", stiffness, E / Kernel(nu, radius)(surface, surface)(0, 0));
    EXPECT_NEAR(stiffness, 19.74, 0.005);    // 2aE*, validation.md, last paragraph of Solids
}

TEST(HalfSpace, PointLoadOfTheTable) {
    // validation.md: 1.935 mm at r = 5 mm for 1 N on E = 25 kPa, ν = 0.49; four digits are printed there.
    const double u = Kernel(0.49, radius)({5e-3, 0.0, 0.0}, surface)(2, 2) / 25e3;
    std::printf("point load: %.4f mm\n", 1e3 * u);
    EXPECT_NEAR(1e3 * u, 1.935, 0.002);
}

std::unique_ptr<TissueModel> make(const Case& with) {
    return contract::make<TissueModel>(STYLET_PLUGIN_FILE, with);
}

TEST(HalfSpace, InterfaceBelongsToTheLayerBelow) {
    const Case layered{.name = "layered", .tissue = two_layers()};
    const auto tissue = make(layered);
    const double z = -5e-3;
    EXPECT_EQ(tissue->locate({0.0, 0.0, z}).layer, 1);
    EXPECT_EQ(tissue->locate({0.0, 0.0, std::nextafter(z, 0.0)}).layer, 0);
    EXPECT_EQ(tissue->locate({0.0, 0.0, std::nextafter(z, -1.0)}).layer, 1);
    EXPECT_EQ(tissue->locate({0.0, 0.0, 1e-3}).layer, outside);
    EXPECT_EQ(tissue->locate({0.0, 0.0, -layered.tissue.extent.z() - 1e-3}).layer, outside);
}

TEST(HalfSpace, IsEnteredThroughItsSurfaceOnly) {
    const Case gel{.name = "gel"};
    const auto tissue = make(gel);
    EXPECT_NEAR(tissue->entry({0.0, 0.0, 3e-3}, {0.0, 0.0, -1e-3}), 0.75, rounding);
    EXPECT_EQ(tissue->entry({0.0, 0.0, 0.0}, {0.0, 0.0, -1e-12}), 0.0);
    EXPECT_LT(tissue->entry({0.0, 0.0, -1e-3}, {0.0, 0.0, -2e-3}), 0.0) << "inside already";
    EXPECT_LT(tissue->entry({0.0, 0.0, -1e-3}, {0.0, 0.0, 1e-3}), 0.0) << "on the way out";
    EXPECT_LT(tissue->entry({1.0, 0.0, 1e-3}, {1.0, 0.0, -1e-3}), 0.0) << "beside the block";
}

TEST(HalfSpace, SaysWhenTheDentIsDeeperThanTheBlock) {
    const Case gel{.name = "gel"};
    const auto tissue = make(gel);
    const ContactPoint tip{.material = surface, .span = Vector3::Zero(), .arclength = 0.2, .tip = true};
    const double limit = gel.tissue.extent.z() * gel.tissue.layers.front().youngs_modulus /
                         Kernel(gel.tissue.layers.front().poisson_ratio, gel.needle.radius)(surface, surface)(2, 2);
    for (const double share : {0.99, 1.01}) {
        const VectorX force = (VectorX(3) << 0.0, 0.0, -share * limit).finished();
        (void)tissue->try_step({&tip, 1}, {force.data(), 3});
        tissue->commit();
        EXPECT_EQ(tissue->beyond_validity() != nullptr, share > 1.0);
    }
}

TEST(HalfSpace, RefusesLayersOfDifferentPoissonRatios) {
    Case mixed{.name = "mixed", .tissue = two_layers()};
    mixed.tissue.layers.front().poisson_ratio = 0.3;
    EXPECT_THROW(make(mixed), Error);
}

}    // namespace
}    // namespace stylet
