// A needle's section, and the models of its critical load.
#include "core/scene/gauges.h"
#include "test_scenes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <sstream>
#include <string>

namespace stylet::core {
namespace {

Scene with_needle(const std::string& section) {
    const std::string common = ", type: beam_column, length: 200 mm, youngs_modulus: 200 GPa, ends: clamped-free}";
    return read_scene(good_scene(), {{"needle", "{" + section + common}}, good_plugins());
}

TEST(Gauges, BecomeThinnerWithTheirNumberAndAreAllTubes) {
    double last = 1.0;
    for (const Gauge& gauge : gauges()) {
        EXPECT_LT(gauge.outer_diameter, last) << gauge.name;
        EXPECT_LT(gauge.inner_diameter, gauge.outer_diameter) << gauge.name;
        EXPECT_GT(gauge.inner_diameter, 0.0) << gauge.name;
        last = gauge.outer_diameter;
    }
}

TEST(Gauges, AreNearTheMetricSizesOfIso9626) {
    // ISO 9626:2016, table 1: the designated metric size [mm] of each gauge, which is rounded to what tubing is drawn to.
    const std::map<std::string, double> sizes{{"10G", 3.4}, {"11G", 3.0},  {"12G", 2.7},  {"13G", 2.4},  {"14G", 2.1},
                                              {"15G", 1.8}, {"16G", 1.6},  {"17G", 1.4},  {"18G", 1.2},  {"19G", 1.1},
                                              {"20G", 0.9}, {"21G", 0.8},  {"22G", 0.7},  {"23G", 0.6},  {"24G", 0.55},
                                              {"25G", 0.5}, {"26G", 0.45}, {"27G", 0.4},  {"28G", 0.36}, {"29G", 0.33},
                                              {"30G", 0.3}, {"31G", 0.25}, {"32G", 0.23}, {"33G", 0.2},  {"34G", 0.18}};
    constexpr double rounding = 0.07;    // 23G, the farthest off, has 0.6414 mm for a size of 0.6 mm
    double worst = 0.0;
    for (const auto& [name, size] : sizes) {
        const Gauge* const gauge = find_gauge(name);
        ASSERT_NE(gauge, nullptr) << name;
        const double off = std::abs(gauge->outer_diameter * 1e3 / size - 1.0);
        EXPECT_LT(off, rounding) << name;
        worst = std::max(worst, off);
    }
    std::printf("%zu gauges, at most %.1f %% from the metric size of ISO 9626\n", sizes.size(), 100.0 * worst);
}

TEST(Gauges, AreAllDeclaredAsChoices) {
    std::istringstream words(gauge_names);
    std::string word;
    for (const Gauge& gauge : gauges()) {
        ASSERT_TRUE(words >> word);
        EXPECT_EQ(word, gauge.name);
    }
    EXPECT_FALSE(words >> word);
}

TEST(NeedleSection, TakesBothRadiiFromAGauge) {
    const Scene scene = with_needle("gauge: 22G");
    EXPECT_EQ(scene.gauge, "22G");
    EXPECT_DOUBLE_EQ(scene.needle_setup->radius, 0.3588e-3);
    EXPECT_DOUBLE_EQ(scene.needle_setup->inner_radius, 0.2065e-3);
}

TEST(NeedleSection, IsSolidWhereItGivesOnlyARadius) {
    const Scene scene = with_needle("radius: 0.3 mm");
    EXPECT_EQ(scene.gauge, "");
    EXPECT_EQ(scene.needle_setup->inner_radius, 0.0);
    EXPECT_DOUBLE_EQ(scene.needle_setup->bending_stiffness(), 200e9 * std::numbers::pi * std::pow(0.3e-3, 4) / 4.0);
}

TEST(NeedleSection, ATubeBendsLikeASolidNeedleWithoutItsCore) {
    const double tube = with_needle("radius: 0.4 mm, inner_radius: 0.3 mm").needle_setup->bending_stiffness();
    const double whole = with_needle("radius: 0.4 mm").needle_setup->bending_stiffness();
    const double core = with_needle("radius: 0.3 mm").needle_setup->bending_stiffness();
    EXPECT_DOUBLE_EQ(tube, whole - core);
}

TEST(NeedleSection, AnOverrideOfOneThicknessReplacesTheScenesOther) {
    const Scene gauge = read_scene(good_scene(), {{"needle.gauge", "22G"}}, good_plugins());
    EXPECT_EQ(gauge.gauge, "22G");
    EXPECT_DOUBLE_EQ(gauge.needle_setup->radius, 0.3588e-3);
    EXPECT_EQ(complaints({{"needle.gauge", "22G"}, {"needle.radius", "0.3 mm"}}).size(), 1u);    // both at once stay a clash
}

TEST(NeedleSection, AnUnknownGaugeIsOneMistakeAndTheNextThinnerOrThickerIsMeant) {
    const std::vector<std::string> messages = complaints({{"needle.gauge", "35G"}});
    ASSERT_EQ(messages.size(), 1u);
    EXPECT_TRUE(messages.front().ends_with("; did you mean '34G'?")) << messages.front();
}

TEST(NeedleSection, KeepsAWallThatRoundingDoesNotLose) {
    EXPECT_GT(with_needle("radius: 0.4 mm, inner_radius: 0.39999 mm").needle_setup->bending_stiffness(), 0.0);
    EXPECT_EQ(complaints({{"needle.inner_radius", "0.29999999999 mm"}}).size(), 1u);
}

TEST(BucklingSection, SwapsAModelByOneWordAndNamesTheOthers) {
    const std::string maps = ", strut: {strength: 2 kPa, form: printed}}";
    const Scene plain = read_scene(good_scene(), {{"needle.buckling", "{type: euler" + maps}}, good_plugins());
    EXPECT_EQ(plain.buckling->type, "euler");
    EXPECT_EQ(plain.buckling->alternatives, std::vector<std::string>{"strut"});
    const Scene swapped = read_scene(good_scene(), {{"needle.buckling", "{type: strut, euler: {}" + maps}}, good_plugins());
    EXPECT_DOUBLE_EQ(swapped.buckling->parameters.number("strength"), 2000.0);
    EXPECT_EQ(swapped.buckling->parameters.text("form"), "printed");
    EXPECT_EQ(swapped.buckling->alternatives, std::vector<std::string>{"euler"});
}

}    // namespace
}    // namespace stylet::core
