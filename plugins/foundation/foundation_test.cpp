// The paper's tables: tests/critical_loads.
#include <stylet/contract/contract.h>
#include <stylet/foundation_equation.h>

#include <cmath>
#include <string>

namespace stylet {
namespace {

using contract::Case;
using contract::Given;

NeedleSetup free_needle() {
    NeedleSetup needle = contract::steel_needle();
    needle.ends = Ends::clamped_free;
    return needle;
}

Case vesic(const char* name, const char* form) {
    return {.name = name,
            .parameters = {{"form", std::string(form)}, {"foundation_modulus", std::string("vesic")}},
            .needle = free_needle()};
}

STYLET_CONTRACT(vesic("Printed", "printed"), vesic("Consistent", "consistent"),
                Case{.name = "InAir", .parameters = {{"form", "printed"}}, .needle = free_needle(), .has_tissue = false})

constexpr double soft = 3e3, stiff = 40e3;    // [Pa] μ of the layers

Case two_layers() {
    Case scene = vesic("TwoLayers", "consistent");
    scene.tissue.layers = {
        {.name = "fat", .youngs_modulus = 1.0, .poisson_ratio = 0.3, .density = 900.0, .thickness = 0.02},
        {.name = "muscle", .youngs_modulus = 1.0, .poisson_ratio = 0.3, .density = 900.0, .thickness = 0.13},
    };
    scene.parameters.set("foundation_modulus", std::string("given"));
    scene.parameters.set("given", Parameters::Records{Given{{"layer", std::string("fat")}, {"modulus", soft}},
                                                      Given{{"layer", std::string("muscle")}, {"modulus", stiff}}});
    return scene;
}

/// [N] with so much of a needle of 100 mm in two layers of tissue.
double load(double inserted) {
    static const Case scene = two_layers();
    static const auto model = contract::make<BucklingModel>(STYLET_PLUGIN_FILE, scene);
    return model->critical_load({.bending_stiffness = scene.needle.bending_stiffness(),
                                 .free_length = 0.1 - inserted,
                                 .inserted = inserted,
                                 .depth = inserted,
                                 .radius = scene.needle.radius,
                                 .ends = Ends::clamped_free});
}

double equation_2(double stiffness) {
    return foundation_load(free_needle().bending_stiffness(), 0.1, stiffness, FoundationForm::consistent);
}

TEST(FoundationFormula, IsEquation2WithTheTipsLayerWhereAllIsInTissue) {
    constexpr double rounding = 1e-14;    // relative
    EXPECT_NEAR(load(0.1), equation_2(stiff), rounding * equation_2(stiff));
}

TEST(FoundationFormula, IsEquation1WhereNothingIsInTissue) {
    EXPECT_EQ(load(0.0), equation_2(0.0));
}

// ∫ (1 − cos πx/2l)² dx from l/2 to l is 0.8995 of that from 0: 1 − (3/4 − 4/π sin π/4 + 1/2π)/(3/2 − 4/π).
TEST(FoundationFormula, HalfInTissueHasThatHalfsShareOfTheShape) {
    constexpr double rounding = 1e-12;    // relative
    const double half = 0.75 - 4.0 / M_PI * std::sqrt(0.5) + 0.5 / M_PI, whole = 1.5 - 4.0 / M_PI;
    const double expected = equation_2((1.0 - half / whole) * stiff);
    EXPECT_NEAR(load(0.05), expected, rounding * expected);
}

TEST(FoundationFormula, GrowsWithoutAJumpWithinALayerAndJumpsBetweenTwo) {
    constexpr double step = 1e-6;    // [m]
    EXPECT_GT(load(step), load(0.0));
    EXPECT_LT(load(step) / load(0.0), 1.01);
    EXPECT_GT(load(0.02 + step) / load(0.02 - step), 1.5);
}

TEST(FoundationFormula, RefusesEveryOtherNeedle) {
    for (const Ends ends : {Ends::pinned_pinned, Ends::clamped_pinned, Ends::clamped_clamped}) {
        Case scene = two_layers();
        scene.needle.ends = ends;
        try {
            (void)contract::make<BucklingModel>(STYLET_PLUGIN_FILE, scene);
            ADD_FAILURE() << "taken";
        } catch (const Error& error) {
            EXPECT_EQ(error.key(), "needle.ends");
            EXPECT_STREQ(
                error.what(),
                "found other ends than clamped-free, wanted `ends: clamped-free`: Eq. (2) is of such a column (winkler takes "
                "any ends)");
        }
    }
}

}    // namespace
}    // namespace stylet
