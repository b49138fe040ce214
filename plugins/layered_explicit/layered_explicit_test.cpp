// The paper's tables, and how far it is above the converged load: tests/critical_loads.
#include <stylet/contract/contract.h>

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

Case vesic(const char* name, std::int64_t terms) {
    return {
        .name = name, .parameters = {{"terms", terms}, {"foundation_modulus", std::string("vesic")}}, .needle = free_needle()};
}

STYLET_CONTRACT(vesic("TwoTerms", 2), vesic("ThreeTerms", 3),
                Case{.name = "InAir", .parameters = {{"terms", std::int64_t{2}}}, .needle = free_needle(), .has_tissue = false})

/// [N] of a needle of 100 mm wholly in tissue whose layers, so thick [m], have one modulus [Pa].
double load(std::int64_t terms, double modulus, const std::vector<double>& thicknesses) {
    Case scene = vesic("Layers", terms);
    scene.tissue.layers.clear();
    Parameters::Records given;
    for (const double thickness : thicknesses) {
        const std::string name = "layer " + std::to_string(given.size());
        scene.tissue.layers.push_back(
            {.name = name, .youngs_modulus = 1.0, .poisson_ratio = 0.3, .density = 900.0, .thickness = thickness});
        given.push_back(Given{{"layer", name}, {"modulus", modulus}});
    }
    scene.parameters.set("foundation_modulus", std::string("given"));
    scene.parameters.set("given", given);
    const auto model = contract::make<BucklingModel>(STYLET_PLUGIN_FILE, scene);
    return model->critical_load({.bending_stiffness = scene.needle.bending_stiffness(),
                                 .free_length = 0.0,
                                 .inserted = 0.1,
                                 .depth = 0.1,
                                 .radius = scene.needle.radius,
                                 .ends = Ends::clamped_free});
}

constexpr double modulus = 10e3;    // [Pa]

TEST(LayeredExplicit, InAirIsEulers) {
    constexpr double rounding = 1e-13;    // relative
    const double euler = M_PI * M_PI / 4.0 * free_needle().bending_stiffness() / 0.01;
    EXPECT_NEAR(load(2, 0.0, {0.1}), euler, rounding * euler);
    EXPECT_NEAR(load(3, 0.0, {0.1}), euler, rounding * euler);
}

TEST(LayeredExplicit, OfOnePieceIsTheClosedForm) {
    constexpr double rounding = 1e-12;    // relative
    const double stiffness = free_needle().bending_stiffness(), kappa = modulus * 1e-4 / stiffness;
    const double a1 = 0.5 * M_PI, a2 = 1.5 * M_PI;
    const double a11 = a1 * a1 + kappa * 2.0 / (a1 * a1) * (1.5 - 2.0 / a1);
    const double a22 = a2 * a2 + kappa * 2.0 / (a2 * a2) * (1.5 + 2.0 / a2);
    const double a12 = kappa * 2.0 / (a1 * a2) * (1.0 - 1.0 / a1 + 1.0 / a2);
    const double root = 0.5 * (a11 + a22) - std::sqrt(0.25 * (a11 - a22) * (a11 - a22) + a12 * a12);
    const double expected = root * stiffness / 0.01;
    EXPECT_NEAR(load(2, modulus, {0.1}), expected, rounding * expected);
}

TEST(LayeredExplicit, LayersOfOneModulusAreOneLayer) {
    constexpr double rounding = 1e-13;    // relative
    for (const std::int64_t terms : {2, 3}) {
        const double whole = load(terms, modulus, {0.1});
        EXPECT_NEAR(load(terms, modulus, {0.01, 0.033, 0.002, 0.055}), whole, rounding * whole);
    }
}

TEST(LayeredExplicit, EveryTermBringsTheBoundDown) {
    EXPECT_LT(load(3, modulus, {0.1}), load(2, modulus, {0.1}));
}

TEST(LayeredExplicit, RefusesEveryOtherNeedle) {
    for (const Ends ends : {Ends::pinned_pinned, Ends::clamped_pinned, Ends::clamped_clamped}) {
        Case scene = vesic("Held", 2);
        scene.needle.ends = ends;
        try {
            (void)contract::make<BucklingModel>(STYLET_PLUGIN_FILE, scene);
            ADD_FAILURE() << "taken";
        } catch (const Error& error) {
            EXPECT_EQ(error.key(), "needle.ends");
            EXPECT_STREQ(error.what(),
                         "found other ends than clamped-free, wanted `ends: clamped-free`: these functions are of such a column "
                         "(winkler takes any ends)");
        }
    }
}

}    // namespace
}    // namespace stylet
