#include "core/scene/scene_hash.h"
#include "test_scenes.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace stylet::core {
namespace {

Scene good(const std::vector<Override>& overrides) {
    return read_scene(good_scene(), overrides, good_plugins());
}

TEST(Overrides, ReplaceAValueAtAnyDepth) {
    const Scene scene =
        good({{"needle.length", "150 mm"}, {"effects[0].rupture_force", "1 N"}, {"tissue.layers[1].poisson_ratio", "0.3"}});
    EXPECT_DOUBLE_EQ(scene.needle_setup->length, 0.15);
    EXPECT_DOUBLE_EQ(scene.effects[0].parameters.number("rupture_force"), 1.0);
    EXPECT_DOUBLE_EQ(scene.tissue_setup->layers[1].poisson_ratio, 0.3);
}

TEST(Overrides, AddAKeyThatTheSceneLeavesOut) {
    EXPECT_EQ(good({{"tissue.lattice.damping", "2 1/s"}, {"tissue.type", "lattice"}}).tissue->parameters.number("damping"), 2.0);
}

TEST(Overrides, TakeWholeListsAndMaps) {
    EXPECT_TRUE(good({{"effects", "[]"}}).effects.empty());
    EXPECT_EQ(good({{"run", "{rate: 500 Hz}"}}).run.duration, std::nullopt);
}

TEST(Overrides, TheLastOneOfAKeyCounts) {
    EXPECT_DOUBLE_EQ(good({{"run.rate", "2 kHz"}, {"run.rate", "500 Hz"}}).run.rate, 500.0);
}

TEST(Overrides, AreCheckedAsTheSceneIs) {
    const Messages expected{
        "--set needle.radius: found '1' without a unit, wanted a length in m such as '25 mm' (needle radius; either this or "
        "`gauge`)",
        "--set needle.lenth: found an unknown key, wanted one of type, length, gauge, radius, inner_radius, youngs_modulus, "
        "ends, buckling, or a map named after a needle; did you mean 'length'?"};
    Messages found = complaints({{"needle.radius", "1"}, {"needle.lenth", "1 m"}});
    std::ranges::sort(found, std::greater());
    EXPECT_EQ(found, expected);
}

TEST(Overrides, MayNotLeaveATypeEmpty) {
    const Messages expected{"--set device.type: found '', wanted the name of a device"};
    EXPECT_EQ(complaints({{"device.type", "''"}}), expected);
}

TEST(Overrides, SayWhichParentIsNotThere) {
    const Messages expected{"--set nedle.radius: found no key 'nedle' in the scene; did you mean 'needle'?"};
    EXPECT_EQ(complaints({{"nedle.radius", "1 mm"}}), expected);
}

TEST(Overrides, MayMakeTheMapsOnTheirWay) {
    const Scene scene = good({{"needle.buckling.strut.strength", "3 kPa", "--model strut", true},
                              {"needle.buckling.type", "strut", "--model strut", true}});
    EXPECT_DOUBLE_EQ(scene.buckling->parameters.number("strength"), 3000.0);
}

TEST(Overrides, AreNamedAsTheUserGaveThem) {
    const Messages expected{"--model strutt: needle.buckling.type: found no plugin 'strutt' in " GOOD_PLUGINS
                            "; did you mean 'strut'?"};
    EXPECT_EQ(complaints({{"needle.buckling.type", "strutt", "--model strutt", true}}), expected);
}

TEST(Overrides, SayHowLongAListIs) {
    const Messages expected{"--set effects[2].type: found no item [2], 'effects' is a list of 2"};
    EXPECT_EQ(complaints({{"effects[2].type", "friction"}}), expected);
}

TEST(Overrides, SayWhatIsNoListAndWhatIsNoMap) {
    const Messages expected{"--set needle[0]: found a map at 'needle', wanted a list",
                            "--set needle.length.unit: found '200 mm' at 'needle.length', wanted a map"};
    EXPECT_EQ(complaints({{"needle[0]", "x"}, {"needle.length.unit", "m"}}), expected);
}

Override without(const std::string& key) {
    return {.key = key, .value = "", .given = "leave_out: " + key, .removes = true};
}

TEST(Overrides, TakeAKeyOut) {
    ASSERT_TRUE(good({}).buckling);
    const Scene scene = good({without("needle.buckling"), without("run.duration")});
    EXPECT_FALSE(scene.buckling);
    EXPECT_EQ(scene.run.duration, std::nullopt);
}

TEST(Overrides, TakeItemsOutByTheIndicesThatTheyHaveInTheScene) {
    const std::string three =
        "[{type: friction, per_length: 1 N/m}, {type: fracture, rupture_force: 2 N, toughness: 1 J/m^2},"
        " {type: friction, per_length: 3 N/m}]";
    const Scene scene =
        good({{"effects", three}, without("effects[0]"), {"effects[2].per_length", "4 N/m"}, without("effects[1]")});
    ASSERT_EQ(scene.effects.size(), 1u);
    EXPECT_DOUBLE_EQ(scene.effects[0].parameters.number("per_length"), 4.0);
    EXPECT_EQ(scene.effects[0].path, "effects[0]");
}

TEST(Overrides, PutBackWhatWasTakenOut) {
    EXPECT_TRUE(good({without("needle.buckling"), {"needle.buckling", "{type: euler}"}}).buckling);
    EXPECT_EQ(good({without("effects[0]"), {"effects", "[{type: friction, per_length: 1 N/m}]"}}).effects.size(), 1u);
}

TEST(Overrides, SayWhatIsNotThereToBeTakenOut) {
    const Messages no_key{"leave_out: needle.bucklin: found no key 'needle.bucklin' in the scene; did you mean 'buckling'?"};
    EXPECT_EQ(complaints({without("needle.bucklin")}), no_key);
    const Messages no_item{"leave_out: effects[2]: found no item [2], 'effects' is a list of 2"};
    EXPECT_EQ(complaints({without("effects[2]")}), no_item);
    const Messages gone{"leave_out: effects[1]: found no item [1], it was taken out of 'effects'"};
    EXPECT_EQ(complaints({without("effects[1]"), without("effects[1]")}), gone);
}

TEST(Overrides, ThatTakeOutAreAnotherSceneThanThoseThatSetNothing) {
    const Override nothing{"run.duration", ""};
    EXPECT_NE(scene_hash("", {without("run.duration")}, {}), scene_hash("", {nothing}, {}));
    EXPECT_EQ(scene_hash("", {without("run.duration")}, {}), scene_hash("", {without("run.duration")}, {}));
}

TEST(Overrides, RefuseAMalformedKey) {
    for (const char* key :
         {"", ".", "a..b", "[0]", "effects[", "effects[x]", "effects[0", "effects[-1]", "effects]", "run.", "a[0]b"}) {
        const Messages expected{"--set " + std::string(key) +
                                ": found a malformed key, wanted one such as effects[0].rupture_force"};
        EXPECT_EQ(complaints({{key, "1"}}), expected);
    }
}

TEST(Overrides, RefuseBadYaml) {
    const Messages messages = complaints({{"needle.buckling", "{type: euler"}});
    ASSERT_EQ(messages.size(), 1u);
    EXPECT_TRUE(messages[0].starts_with("--set needle.buckling: found text that is not YAML (")) << messages[0];
}

}    // namespace
}    // namespace stylet::core
