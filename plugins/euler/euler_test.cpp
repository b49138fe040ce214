#include <stylet/contract/contract.h>

#include <array>
#include <cmath>

namespace stylet {
namespace {

using contract::Case;

STYLET_CONTRACT(Case{.name = "Steel"},
                Case{.name = "Thin",
                     .needle = {.length = 0.05, .radius = 0.1e-3, .youngs_modulus = 70e9, .ends = Ends::clamped_free}})

const Case plain;

constexpr double youngs_modulus = 200e9;    // [Pa] the needle of the paper
constexpr double radius = 0.3e-3;           // [m]

double load(double length, Ends ends, double needle_radius = radius) {
    const NeedleSetup needle{.length = length, .radius = needle_radius, .youngs_modulus = youngs_modulus, .ends = ends};
    const auto model = contract::make<BucklingModel>(STYLET_PLUGIN_FILE, plain);
    return model->critical_load(
        {.bending_stiffness = needle.bending_stiffness(), .free_length = length, .radius = needle_radius, .ends = ends});
}

TEST(Euler, GivesTheLoadsOfFigure10) {
    constexpr double last_digit = 0.5001e-3;    // [N] the table has three decimals
    struct Row {
        Ends ends;
        std::array<double, 3> loads;    // [N] at 150, 200 and 300 mm
    };
    for (const Row& row : {Row{Ends::clamped_free, {0.140, 0.078, 0.035}}, Row{Ends::pinned_pinned, {0.558, 0.314, 0.140}},
                           Row{Ends::clamped_pinned, {1.142, 0.642, 0.285}}, Row{Ends::clamped_clamped, {2.232, 1.256, 0.558}}}) {
        EXPECT_NEAR(load(0.150, row.ends), row.loads[0], last_digit);
        EXPECT_NEAR(load(0.200, row.ends), row.loads[1], last_digit);
        EXPECT_NEAR(load(0.300, row.ends), row.loads[2], last_digit);
    }
}

TEST(Euler, AThinnerNeedleOfFigure10BucklesAt310Millinewton) {
    constexpr double last_digit = 0.5001e-3;    // [N]
    EXPECT_NEAR(load(0.200, Ends::clamped_pinned, 0.25e-3), 0.310, last_digit);
}

TEST(Euler, AgreesWithThePapersEquation1) {
    constexpr double rounding = 1e-14;                                                     // relative
    const double bending_stiffness = youngs_modulus * M_PI * std::pow(radius, 4) / 4.0;    // [N·m²]
    const double expected = M_PI * M_PI * bending_stiffness / (4.0 * 0.1 * 0.1);
    EXPECT_NEAR(load(0.1, Ends::clamped_free), expected, rounding * expected);
}

TEST(Euler, TheFactorOfClampedPinnedSolvesItsEquation) {
    constexpr double rounding = 1e-12;    // tan has a slope of 21 there
    const double factor = load(0.1, Ends::clamped_pinned) / load(0.1, Ends::pinned_pinned) * M_PI * M_PI;
    EXPECT_NEAR(std::tan(std::sqrt(factor)), std::sqrt(factor), rounding);
}

TEST(Euler, NoFreeLengthBearsWhatALengthOfOneRadiusDoes) {
    EXPECT_EQ(load(0.0, Ends::clamped_pinned), load(radius, Ends::clamped_pinned));
    EXPECT_GT(load(radius, Ends::clamped_pinned), load(1.001 * radius, Ends::clamped_pinned));
}

}    // namespace
}    // namespace stylet
