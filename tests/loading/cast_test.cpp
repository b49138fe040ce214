#include "core/loading/cast.h"

#include "test_scenes.h"

#include <gtest/gtest.h>

namespace stylet::core {
namespace {

Scene scene_with(const std::vector<Override>& overrides) {
    return read_scene(good_scene(), overrides, good_plugins());
}

Messages cast_complaints(const Scene& scene, const PluginFolders& folders = good_plugins()) {
    try {
        const Cast cast(scene, folders);
        return {};
    } catch (const SceneErrors& errors) {
        return errors.messages();
    }
}

std::vector<std::string> library_names(const Cast& cast) {
    std::vector<std::string> names;
    for (const auto& file : cast.libraries()) names.push_back(file.stem().string());
    return names;
}

TEST(Cast, MakesEverythingThatTheSceneNames) {
    const Scene scene = scene_with({});
    const Cast cast(scene, good_plugins());
    EXPECT_EQ(cast.tissue().locate({0.0, 0.0, -0.01}).depth, 0.01);
    EXPECT_EQ(cast.device().limits().force, 10.0);
    ASSERT_EQ(cast.effects().size(), 2u);
    ContactLaw law;
    Contact contact{};
    contact.coverage = 0.1;
    for (const auto& effect : cast.effects()) effect->add_to(contact, law);
    EXPECT_DOUBLE_EQ(law.tip_limit, 0.66);
    EXPECT_DOUBLE_EQ(law.axial_limit, 0.5);
}

TEST(Cast, HandsTheNeedleItsBucklingModel) {
    const Scene scene = scene_with({});
    const Cast cast(scene, good_plugins());
    EXPECT_EQ(cast.needle().state().critical_load, scene.needle_setup->length) << "the test's euler answers with the length";
}

TEST(Cast, OpensLibrariesInAFixedOrderAndEachOnce) {
    const Scene scene = scene_with({{"effects", "[{type: friction, per_length: 1 N/m}, {type: friction, per_length: 2 N/m}]"}});
    const Cast cast(scene, good_plugins());
    EXPECT_EQ(cast.effects().size(), 2u);
    const std::vector<std::string> expected{"euler", "half_space", "beam_column", "friction", "recorded_hand"};
    EXPECT_EQ(library_names(cast), expected);
}

TEST(Cast, MapsNothingThatTheSceneDoesNotUse) {
    const Scene scene =
        scene_with({{"needle", "{type: beam_column, length: 0.2 m, radius: 1 mm, youngs_modulus: 1 GPa, ends: clamped-free}"},
                    {"effects", "[]"}});
    {
        const Cast cast(scene, good_plugins());
        EXPECT_TRUE(is_mapped("half_space"));
        for (const char* unused : {"euler", "lattice", "fracture", "friction"}) EXPECT_FALSE(is_mapped(unused)) << unused;
    }
    for (const char* used : {"half_space", "beam_column", "recorded_hand"}) EXPECT_FALSE(is_mapped(used)) << used;
}

TEST(Cast, NamesTheLineOfAParameterThatAConstructorRefuses) {
    const Scene scene = scene_with({{"effects[1]", "{type: fracture, rupture_force: 1 N, toughness: 1e7 J/m^2}"}});
    const Messages expected{"--set effects[1]: effects[1].toughness: found a tissue tougher than steel"};
    EXPECT_EQ(cast_complaints(scene), expected);
}

TEST(Cast, NamesTheLineOfACommonKeyThatAConstructorRefuses) {
    Scene scene = scene_with({});
    scene.needle_setup->radius = 1e-7;
    const Messages expected{good_scene().string() + ":16:11: needle.radius: found a needle too thin for this model"};
    EXPECT_EQ(cast_complaints(scene), expected);
}

TEST(Cast, NamesTheTypesLineWhereAParameterIsNotThere) {
    const Scene scene = scene_with({{"device", "{type: recorded_hand}"}});
    const Messages expected{"--set device: device.file: found neither a file nor a motion"};
    EXPECT_EQ(cast_complaints(scene), expected);
}

TEST(Cast, TurnsWhateverAConstructorThrowsIntoASentence) {
    const Scene scene = scene_with({{"effects[0]", "{type: throwing, what: error}"},
                                    {"effects[1]", "{type: throwing, what: exception}"},
                                    {"device", "{type: recorded_hand}"}});
    const Messages expected{"--set effects[0]: found a plugin that refuses its scene",
                            "--set effects[1]: the plugin 'throwing' failed: a bug",
                            "--set device: device.file: found neither a file nor a motion"};
    EXPECT_EQ(cast_complaints(scene), expected);
    const Scene odd = scene_with({{"effects[0]", "{type: throwing, what: nothing_known}"}});
    const Messages one{"--set effects[0]: the plugin 'throwing' failed with something that is no exception"};
    EXPECT_EQ(cast_complaints(odd), one);
    EXPECT_FALSE(is_mapped("throwing"));
}

TEST(Cast, SaysWhenALibraryIsGone) {
    const Scene scene = scene_with({});
    const Messages messages = cast_complaints(scene, bad_plugins());
    ASSERT_EQ(messages.size(), 5u) << "tissue, buckling, two effects and the device; the needle waits for its buckling model";
    EXPECT_EQ(messages.front(), good_scene().string() + ":5:9: tissue: found no plugin 'half_space' in " BAD_PLUGINS);
}

}    // namespace
}    // namespace stylet::core
