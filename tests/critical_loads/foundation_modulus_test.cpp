#include <stylet/foundation_equation.h>
#include <stylet/foundation_modulus.h>

#include <gtest/gtest.h>

#include <cstdio>

namespace stylet {
namespace {

constexpr double youngs_modulus = 30e3;    // [Pa]
constexpr double half_side = 5e-3;         // [m] of the paper's block
constexpr double radius = 0.3e-3;          // [m]

const NeedleSetup needle{.length = 0.05, .radius = radius, .youngs_modulus = 200e9, .ends = Ends::clamped_free};

Layer gel(double poisson_ratio) {
    return {
        .name = "gel", .youngs_modulus = youngs_modulus, .poisson_ratio = poisson_ratio, .density = 1000.0, .thickness = 0.05};
}

TEST(FoundationModulus, OfVesicIsAQuarterOfYoungsModulus) {
    constexpr double last_digit = 0.0051;
    const Column column{
        .bending_stiffness = needle.bending_stiffness(), .free_length = 0.0, .radius = radius, .ends = needle.ends};
    EXPECT_NEAR(vesic_modulus(gel(0.3), column) / youngs_modulus, 0.25, last_digit);
    EXPECT_NEAR(vesic_modulus(gel(0.49), column) / youngs_modulus, 0.30, last_digit);
}

/// Of plane finite elements: 80 by 40 biquadratic ones between the disc and a rim or the sides of a square block.
struct Row {
    double poisson_ratio;
    double of_youngs_modulus;
};

TEST(FoundationModulus, OfADiscInARingIsThatOfPlaneFiniteElements) {
    constexpr double elements = 1e-5;    // relative: they gain that much from half as many
    for (const Row& row : {Row{0.0, 1.549627}, Row{0.3, 1.499480}, Row{0.45, 1.870165}, Row{0.49, 2.181939}}) {
        const double ratio = disc_modulus(gel(row.poisson_ratio), radius, half_side) / youngs_modulus;
        EXPECT_NEAR(ratio, row.of_youngs_modulus, elements * row.of_youngs_modulus);
    }
}

TEST(FoundationModulus, OfADiscInABlockIsThatOfPlaneFiniteElements) {
    constexpr double square_is_no_circle = 0.009;    // relative
    const double bound = conformal_radius(2.0 * half_side, 2.0 * half_side);
    EXPECT_NEAR(bound, 1.0787 * half_side, 0.5e-4 * half_side);
    for (const Row& row : {Row{0.0, 1.5026}, Row{0.3, 1.4447}, Row{0.45, 1.7921}, Row{0.49, 2.1020}}) {
        const double ratio = disc_modulus(gel(row.poisson_ratio), radius, bound) / youngs_modulus;
        std::printf("nu %.2f, four sides held: %.4f E, finite elements %.4f E\n", row.poisson_ratio, ratio,
                    row.of_youngs_modulus);
        EXPECT_NEAR(ratio, row.of_youngs_modulus, square_is_no_circle * row.of_youngs_modulus);
    }
}

TEST(FoundationModulus, OfADiscBetweenWallsIsThatOfPlaneFiniteElements) {
    constexpr double fit = 0.003;    // relative
    for (const Row& row : {Row{0.0, 1.0659}, Row{0.1, 0.9932}, Row{0.2, 0.9393}, Row{0.3, 0.9037}, Row{0.4, 0.8896},
                           Row{0.45, 0.8939}, Row{0.49, 0.9065}}) {
        const double bound = radius_between_walls(half_side, row.poisson_ratio);
        const double ratio = disc_modulus(gel(row.poisson_ratio), radius, bound) / youngs_modulus;
        std::printf("nu %.2f, two sides held: %.4f E, finite elements %.4f E\n", row.poisson_ratio, ratio, row.of_youngs_modulus);
        EXPECT_NEAR(ratio, row.of_youngs_modulus, fit * row.of_youngs_modulus);
    }
}

TEST(FoundationModulus, OfADiscBetweenWallsFitsThinnerNeedlesToo) {
    constexpr double fit = 0.003;    // relative
    const double ratio = disc_modulus(gel(0.3), 0.5 * radius, radius_between_walls(half_side, 0.3)) / youngs_modulus;
    EXPECT_NEAR(ratio, 0.7747, fit * 0.7747);
}

TEST(FoundationModulus, OfADiscStaysFiniteInANarrowBlock) {
    EXPECT_EQ(disc_modulus(gel(0.3), radius, 0.5 * radius), disc_modulus(gel(0.3), radius, 2.0 * radius));
    EXPECT_GT(disc_modulus(gel(0.3), radius, 2.0 * radius), disc_modulus(gel(0.3), radius, 4.0 * radius));
}

TEST(FoundationModulus, ALongRectangleIsAStrip) {
    constexpr double rounding = 1e-12;
    EXPECT_NEAR(conformal_radius(2.0, 200.0), 4.0 / M_PI, rounding);
    EXPECT_EQ(conformal_radius(2.0, 3.0), conformal_radius(3.0, 2.0));
}

TEST(FoundationEquation, Equation3UndoesEquation2) {
    constexpr double rounding = 1e-13;    // relative
    for (const FoundationForm form : {FoundationForm::printed, FoundationForm::consistent}) {
        const double load = foundation_load(needle.bending_stiffness(), 0.05, 5629.129, form);
        EXPECT_NEAR(foundation_stiffness(needle.bending_stiffness(), 0.05, load, form), 5629.129, rounding * 5629.129);
    }
}

TEST(FoundationEquation, TheTablesStiffnessesAreTheConsistentForms) {
    constexpr double last_digit = 0.6e-3;           // [Pa]
    for (const auto& [beyond_euler, stiffness] :    // [N], [Pa]
         {std::pair{5.7035, 5629.129}, {7.8955, 7792.546}, {9.0335, 8915.707}}) {
        const double euler = foundation_load(needle.bending_stiffness(), 0.05, 0.0, FoundationForm::consistent);
        EXPECT_NEAR(foundation_stiffness(needle.bending_stiffness(), 0.05, euler + beyond_euler, FoundationForm::consistent),
                    stiffness, last_digit);
    }
}

}    // namespace
}    // namespace stylet
