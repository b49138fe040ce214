#include "contact/regions_felt.h"

#include "mesh/block_mesh.h"

#include <stylet/layered_elasticity.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

namespace stylet::corotational_fem {
namespace {

constexpr double radius = 0.5e-3;    // [m]

TissueSetup two_layers() {
    return {.extent = Vector3(0.04, 0.04, 0.03),
            .fixed = "bottom",
            .layers = {{.name = "soft", .youngs_modulus = 10e3, .poisson_ratio = 0.49, .density = 1000.0, .thickness = 0.01},
                       {.name = "hard", .youngs_modulus = 70e3, .poisson_ratio = 0.45, .density = 1000.0, .thickness = 0.02}}};
}

TEST(RegionsFelt, AreTheStackedLayersWhereAMeshIsOne) {
    const TissueSetup tissue = two_layers();
    const Mesh mesh = block_mesh(tissue, {4, 4, 6});
    const Locator locator(mesh);
    const RegionsFelt felt(mesh, locator, tissue.layers, radius);
    const LayeredElasticity stacked(tissue.layers, radius);
    // Away from the interface exactly; across it the same step, a ball's share of it where the other has a smooth ramp's: 5/32 of
    // it apart at most, and one sample's.
    constexpr double apart = 5.0 / 32.0 + 1.0 / 64.0;
    const double step = std::log(70.0 / 10.0);
    double worst = 0.0, jump = 0.0, last = std::log(10e3);
    for (double depth = 0.0; depth < 0.02; depth += 1e-5) {
        const Felt here = felt.at(Vector3(0.001, 0.002, -depth));
        const double off = std::log(here.youngs_modulus / stacked.modulus(depth));
        if (std::abs(depth - 0.01) > 4.1 * radius) {
            EXPECT_NEAR(off, 0.0, 1e-12) << depth;
        }
        worst = std::max(worst, std::abs(off) / step);
        jump = std::max(jump, std::abs(std::log(here.youngs_modulus) - last) / step);
        last = std::log(here.youngs_modulus);
    }
    std::printf("across an interface: %.3f of its step from the stacked layers', at most %.3f of it in 0.01 mm\n", worst, jump);
    EXPECT_LE(worst, apart);
    EXPECT_LE(jump, 3.0 / 64.0 + 1e-12) << "three samples at once, and rounding";
}

TEST(RegionsFelt, AreTheFirstLayersWhereThereIsNoMesh) {
    const TissueSetup tissue = two_layers();
    const Mesh mesh = block_mesh(tissue, {4, 4, 6});
    const Locator locator(mesh);
    const Felt far = RegionsFelt(mesh, locator, tissue.layers, radius).at(Vector3(1.0, 0.0, 0.0));
    EXPECT_EQ(far.youngs_modulus, 10e3);
    EXPECT_EQ(far.poisson_ratio, 0.49);
}

}    // namespace
}    // namespace stylet::corotational_fem
