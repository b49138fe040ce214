// Closed forms, convergence and layers: tests/critical_loads.
#include <stylet/contract/contract.h>

#include <cmath>
#include <cstdio>

namespace stylet {
namespace {

using contract::Case;

TissueSetup three_layers() {
    TissueSetup tissue = contract::gel_block();
    tissue.fixed = "sides";
    tissue.layers = {{.name = "skin", .youngs_modulus = 80e3, .poisson_ratio = 0.49, .density = 1000.0, .thickness = 0.002},
                     {.name = "fat", .youngs_modulus = 3e3, .poisson_ratio = 0.45, .density = 900.0, .thickness = 0.018},
                     {.name = "muscle", .youngs_modulus = 40e3, .poisson_ratio = 0.3, .density = 1050.0, .thickness = 0.13}};
    return tissue;
}

STYLET_CONTRACT(Case{.name = "Gel", .parameters = {{"foundation_modulus", "vesic"}}},
                Case{.name = "Layers", .parameters = {{"foundation_modulus", "disc_in_block"}}, .tissue = three_layers()},
                Case{.name = "FewElements", .parameters = {{"foundation_modulus", "vesic"}, {"elements", std::int64_t{16}}}},
                Case{.name = "InAir", .has_tissue = false})

TEST(Winkler, InAirGivesEulersLoads) {
    constexpr double elements = 2e-7;    // relative, of 64
    constexpr double length = 0.2;       // [m]
    const Case in_air{.has_tissue = false};
    const auto model = contract::make<BucklingModel>(STYLET_PLUGIN_FILE, in_air);
    const double stiffness = in_air.needle.bending_stiffness();
    struct Row {
        Ends ends;
        double factor;    // of EI/L²
    };
    for (const Row& row :
         {Row{Ends::clamped_free, M_PI * M_PI / 4.0}, Row{Ends::pinned_pinned, M_PI * M_PI},
          Row{Ends::clamped_pinned, std::pow(4.493409457909064, 2)}, Row{Ends::clamped_clamped, 4.0 * M_PI * M_PI}}) {
        const double load = model->critical_load(
            {.bending_stiffness = stiffness, .free_length = length, .radius = in_air.needle.radius, .ends = row.ends});
        const double off = load * length * length / (row.factor * stiffness) - 1.0;
        std::printf("ends %d: off by %.1e\n", static_cast<int>(row.ends), off);
        EXPECT_NEAR(off, 0.0, elements);
    }
}

}    // namespace
}    // namespace stylet
