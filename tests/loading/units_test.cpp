#include "core/scene/units.h"

#include <gtest/gtest.h>

namespace stylet::core {
namespace {

double value_of(const std::string& text, const std::string& unit) {
    const Quantity quantity = read_quantity(text, unit);
    EXPECT_EQ(quantity.problem, "") << text;
    return quantity.value;
}
std::string problem_of(const std::string& text, const std::string& unit) {
    return read_quantity(text, unit).problem;
}

TEST(Units, ConvertToSi) {
    EXPECT_DOUBLE_EQ(value_of("25 kPa", "Pa"), 25000.0);
    EXPECT_DOUBLE_EQ(value_of("0.3mm", "m"), 0.0003);
    EXPECT_DOUBLE_EQ(value_of(" +1e-3  mm ", "m"), 1e-6);
    EXPECT_DOUBLE_EQ(value_of("3 µm", "m"), 3e-6);
    EXPECT_DOUBLE_EQ(value_of("1 g/cm^3", "kg/m^3"), 1000.0);
    EXPECT_DOUBLE_EQ(value_of("164 J/m^2", "J/m^2"), 164.0);
    EXPECT_DOUBLE_EQ(value_of("0.2 N/mm", "N/m"), 200.0);
    EXPECT_DOUBLE_EQ(value_of("1 kHz", "Hz"), 1000.0);
    EXPECT_DOUBLE_EQ(value_of("180 deg", "rad"), 3.14159265358979323846);
    EXPECT_DOUBLE_EQ(value_of("1 kg m s-2", "N"), 1.0);
}

TEST(Units, AreShownByExamplesThatCanBeRead) {
    for (const std::string unit : {"m", "Pa", "N/m", "J/m^2", "kg/m^3", "N*s/m", "K", "m^2/s"}) {
        EXPECT_GT(value_of(example_of(unit), unit), 0.0) << example_of(unit);
    }
}

TEST(Units, ReadANumberWithoutADimensionAsItStands) {
    EXPECT_EQ(value_of("0.49", "1"), 0.49);
    EXPECT_EQ(value_of("-15", "1"), -15.0);
}

TEST(Units, MustBeGivenWhereThereIsADimension) {
    EXPECT_EQ(problem_of("25", "Pa"), "'25' without a unit");
}

TEST(Units, MustNotBeGivenWhereThereIsNone) {
    EXPECT_EQ(problem_of("0.49 Pa", "1"), "'0.49 Pa'");
    EXPECT_EQ(problem_of("49 %", "1"), "'49 %'");
}

TEST(Units, MustBeOfTheDimensionWanted) {
    EXPECT_EQ(problem_of("25 mm", "Pa"), "'25 mm'");
}

TEST(Units, MustBeKnown) {
    EXPECT_EQ(problem_of("25 kPascals_of_mine", "Pa"), "'25 kPascals_of_mine', whose unit 'kPascals_of_mine' is unknown");
}

TEST(Units, RefuseWhatIsNoNumber) {
    for (const char* text :
         {"", "mm", "kPa 25", "0x10", "--1 m", "+-1 m", "1..2 m", "1,5 mm", "1 2 mm", "1 m from 5", "1 m @ 2", "1 m/0"}) {
        EXPECT_NE(problem_of(text, "m"), "") << text;
    }
}

TEST(Units, RefuseWhatIsNotFinite) {
    EXPECT_EQ(problem_of("inf", "1"), "'inf', which is not finite");
    EXPECT_EQ(problem_of("-nan m", "m"), "'-nan m', which is not finite");
    EXPECT_EQ(problem_of("1e400 m", "m"), "'1e400 m', which no double can hold");
    EXPECT_EQ(problem_of("1e300 Ym", "m"), "'1e300 Ym', which is not finite");
}

TEST(Units, AreNamedByTheirDimension) {
    EXPECT_EQ(wanted_quantity("Pa"), "a pressure in Pa such as '25 kPa'");
    EXPECT_EQ(wanted_quantity("1"), "a number without a unit");
    EXPECT_EQ(wanted_quantity("m^4"), "a quantity in m^4 such as '1 m^4'");
}

}    // namespace
}    // namespace stylet::core
