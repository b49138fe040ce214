// Tables 1 and 2 of He, Chen and Tang by every model of a needle in tissue. Layer 1 is at the needle's free end: the other
// reading is 20 to 41 % off.
#include "layered_column.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <numeric>

namespace stylet {
namespace {

using contract::Given;

/// The paper's three stiffnesses μ, and the Winkler moduli k whose homogeneous column of 50 mm has the same load as they have in
/// the consistent form of Eq. (2).
struct Tissue {
    double stiffness;    // [Pa] μ
    double modulus;      // [Pa] k
};
constexpr Tissue soft{5629.129, 28.525e3}, medium{7792.546, 58.236e3}, stiff{8915.707, 77.327e3};

struct Part {
    Tissue tissue;
    double fraction;    // of the length
};

struct Row {
    const char* name;
    std::vector<Part> parts;    // from the free end, as the paper counts
    double published;           // [N]
    double winkler;             // [N] by a converged beam on the moduli k, worked out independently
};

const std::array rows{
    Row{"1.1", {{soft, 0.5}, {medium, 0.5}}, 7.000, 7.043},
    Row{"1.2", {{medium, 0.5}, {soft, 0.5}}, 9.001, 8.929},
    Row{"1.3", {{soft, 0.25}, {medium, 0.75}}, 6.994, 7.120},
    Row{"1.4", {{medium, 0.25}, {soft, 0.75}}, 8.659, 8.775},
    Row{"1.5", {{soft, 0.75}, {medium, 0.25}}, 6.909, 6.971},
    Row{"1.6", {{medium, 0.75}, {soft, 0.25}}, 9.058, 9.135},
    Row{"2.1", {{soft, 0.2}, {medium, 0.4}, {stiff, 0.4}}, 7.179, 7.268},
    Row{"2.2", {{stiff, 0.2}, {medium, 0.4}, {soft, 0.4}}, 10.078, 9.896},
    Row{"2.3", {{soft, 0.25}, {medium, 0.25}, {stiff, 0.5}}, 7.172, 7.168},
    Row{"2.4", {{stiff, 0.25}, {medium, 0.25}, {soft, 0.5}}, 10.337, 9.746},
};

constexpr double length = 0.05;    // [m]

LayeredColumn column_of(const Row& row, double Tissue::*value) {
    LayeredColumn column;
    for (auto part = row.parts.rbegin(); part != row.parts.rend(); ++part)    // the free end is the tip, the deepest
        column.beds.push_back({part->fraction * length, part->tissue.*value});
    return column;
}

const Given two_terms{{"terms", std::int64_t{2}}}, three_terms{{"terms", std::int64_t{3}}};
const Given printed{{"form", std::string("printed")}}, consistent{{"form", std::string("consistent")}};

double per_cent(double load, double published) {
    return 100.0 * (load / published - 1.0);
}

TEST(Tables1And2, CalibratedModuliGiveTheHomogeneousLoads) {
    constexpr double calibration = 1e-4;    // relative: five digits of the moduli
    for (const Tissue& tissue : {soft, medium, stiff}) {
        const double by_modulus = LayeredColumn{.beds = {{length, tissue.modulus}}}.load("winkler");
        const double by_stiffness = LayeredColumn{.beds = {{length, tissue.stiffness}}}.load("foundation", consistent);
        std::printf("k %.0f Pa: %.4f N, mu %.3f Pa: %.4f N\n", tissue.modulus, by_modulus, tissue.stiffness, by_stiffness);
        EXPECT_NEAR(by_modulus, by_stiffness, calibration * by_stiffness);
    }
}

TEST(Tables1And2, AreReproducedByAConvergedBeamOnCalibratedModuli) {
    constexpr double last_digit = 0.6e-3;    // [N] of the independent column, and of k
    constexpr double mesh_noise = 2.0;       // [%] of the paper's own finite elements
    constexpr double of_the_last = 6.0;      // [%] row 2.4 bears more than its stiffest layer alone: no one mesh gives that
    std::printf("row  paper N | winkler      | 2 terms      | 3 terms      | Eq. (2) printed | consistent\n");
    for (const Row& row : rows) {
        const LayeredColumn on_moduli = column_of(row, &Tissue::modulus), on_springs = column_of(row, &Tissue::stiffness);
        const double winkler = on_moduli.load("winkler");
        std::printf("%s %8.3f", row.name, row.published);
        for (const double load :
             {winkler, on_moduli.load("layered_explicit", two_terms), on_moduli.load("layered_explicit", three_terms),
              on_springs.load("foundation", printed), on_springs.load("foundation", consistent)})
            std::printf(" | %6.3f %+.1f %%", load, per_cent(load, row.published));
        std::printf("\n");
        EXPECT_NEAR(winkler, row.winkler, last_digit) << row.name;
        EXPECT_LT(std::abs(per_cent(winkler, row.published)), &row == &rows.back() ? of_the_last : mesh_noise) << row.name;
    }
}

TEST(Tables1And2, ExplicitEquationIsCloseToTheConvergedLoad) {
    constexpr double two = 0.011, three = 0.006;    // relative; these columns have l (k/EI)^1/4 up to 4.4
    for (const Row& row : rows) {
        const LayeredColumn column = column_of(row, &Tissue::modulus);
        const double winkler = column.load("winkler");
        EXPECT_LT(column.load("layered_explicit", two_terms), (1.0 + two) * winkler) << row.name;
        EXPECT_LT(column.load("layered_explicit", three_terms), (1.0 + three) * winkler) << row.name;
    }
}

TEST(Tables1And2, TheOtherEndForLayer1IsFarOff) {
    constexpr double least = 0.15;    // relative, of the rows whose end layers differ most
    for (const Row& row : {rows[0], rows[1], rows[6], rows[7]}) {
        Row turned = row;
        std::reverse(turned.parts.begin(), turned.parts.end());
        EXPECT_GT(std::abs(column_of(turned, &Tissue::modulus).load("winkler") / row.published - 1.0), least) << row.name;
    }
}

TEST(Equation2, GivesTheTablesOrderOnlyWithTheEffectiveLengthInBothTerms) {
    constexpr double last_digit = 0.0051;    // [N]
    const auto load = [](double stiffness, const Given& form) {
        return LayeredColumn{.beds = {{length, stiffness}}}.load("foundation", form);
    };
    EXPECT_NEAR(load(soft.stiffness, printed), 2.68, last_digit);
    EXPECT_NEAR(load(medium.stiffness, printed), 3.23, last_digit);
    EXPECT_NEAR(load(stiff.stiffness, printed), 3.51, last_digit);
    EXPECT_NEAR(load(soft.stiffness, consistent), 6.959, 0.1 * last_digit);
    EXPECT_NEAR(load(medium.stiffness, consistent), 9.151, 0.1 * last_digit);
    EXPECT_NEAR(load(stiff.stiffness, consistent), 10.289, 0.1 * last_digit);
}

}    // namespace
}    // namespace stylet
