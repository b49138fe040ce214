#include "core/run/sample.h"
#include "test_scenes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace stylet::core {
namespace {

Scene good(const std::vector<Override>& overrides = {}) {
    return read_scene(good_scene(), overrides, good_plugins());
}

/// A folder that goes with the test.
class Folder {
public:
    Folder() {
        std::string name = (std::filesystem::temp_directory_path() / "stylet_XXXXXX").string();
        path_ = mkdtemp(name.data());
    }
    ~Folder() { std::filesystem::remove_all(path_); }
    void write(const std::filesystem::path& file, const std::string& text) const {
        std::filesystem::create_directories((path_ / file).parent_path());
        std::ofstream(path_ / file) << text;
    }
    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

TEST(GoodScene, ReadsTheTissueInSi) {
    const Scene scene = good();
    EXPECT_EQ(scene.title, "A needle for tests");
    EXPECT_EQ(scene.tissue->type, "half_space");
    EXPECT_EQ(scene.tissue_setup->fixed, "bottom");
    EXPECT_TRUE(scene.tissue_setup->extent.isApprox(Vector3(0.15, 0.15, 0.15)));
    ASSERT_EQ(scene.tissue_setup->layers.size(), 2u);
    const Layer& skin = scene.tissue_setup->layers[0];
    EXPECT_EQ(skin.name, "skin");
    EXPECT_DOUBLE_EQ(skin.youngs_modulus, 1e5);
    EXPECT_DOUBLE_EQ(skin.poisson_ratio, 0.45);
    EXPECT_TRUE(std::isnan(skin.density));
    EXPECT_DOUBLE_EQ(skin.thickness, 0.002);
    const Layer& gel = scene.tissue_setup->layers[1];
    EXPECT_DOUBLE_EQ(gel.density, 1000.0);
    EXPECT_DOUBLE_EQ(gel.thickness, 0.148) << "the last layer reaches the bottom";
}

TEST(GoodScene, ReadsTheNeedleInSi) {
    const Scene scene = good();
    EXPECT_EQ(scene.needle->type, "beam_column");
    EXPECT_DOUBLE_EQ(scene.needle_setup->length, 0.2);
    EXPECT_DOUBLE_EQ(scene.needle_setup->radius, 0.0003);
    EXPECT_DOUBLE_EQ(scene.needle_setup->youngs_modulus, 2e11);
    EXPECT_EQ(scene.needle_setup->ends, Ends::clamped_pinned);
    ASSERT_TRUE(scene.buckling);
    EXPECT_EQ(scene.buckling->type, "euler");
}

TEST(GoodScene, ReadsEffectsDeviceAndRunInSi) {
    const Scene scene = good();
    ASSERT_EQ(scene.effects.size(), 2u);
    EXPECT_EQ(scene.effects[0].parameters.number("rupture_force"), 0.66);
    EXPECT_EQ(scene.effects[1].parameters.number("per_length"), 5.0);
    const Parameters& device = scene.device->parameters;
    EXPECT_EQ(device.text("file"), (std::filesystem::canonical(SCENES) / "hands/steady.csv").string());
    ASSERT_EQ(device.records("motion").size(), 2u);
    EXPECT_EQ(device.records("motion")[0].text("way"), "insert");
    EXPECT_FALSE(device.records("motion")[0].has("times"));
    EXPECT_DOUBLE_EQ(device.records("motion")[0].number("speed"), 0.01);
    EXPECT_EQ(device.records("motion")[1].integer("times"), 3);
    EXPECT_EQ(scene.force_limit, 5.0);
    EXPECT_DOUBLE_EQ(scene.contact_spacing, 0.005);
    EXPECT_DOUBLE_EQ(scene.run.rate, 1000.0);
    EXPECT_EQ(scene.run.duration, 8.0);
    const std::vector<std::string> record{"depth", "hand_force", "ledger"};
    EXPECT_EQ(scene.record, record);
}

TEST(GoodScene, KnowsTheLineOfEachParameter) {
    const Scene scene = good();
    EXPECT_EQ(scene.places.at("effects[1].per_length").line, 22);
    EXPECT_EQ(scene.places.at("effects[1].per_length").column, 34);
    EXPECT_EQ(scene.device->place.line, 24);
    EXPECT_EQ(scene.effects[1].path, "effects[1]");
}

TEST(GoodScene, LeavesNoLibraryOpen) {
    (void)good();
    for (const std::string& plugin : good_plugins().names()) EXPECT_FALSE(is_mapped(plugin)) << plugin;
}

TEST(GoodScene, SwapsAModelByOneWord) {
    const Scene scene = good({{"tissue.type", "lattice"}});
    EXPECT_EQ(scene.tissue->type, "lattice");
    EXPECT_EQ(scene.tissue->parameters.vector3("cells"), Vector3(15.0, 15.0, 15.0));
}

TEST(GoodScene, NeedsNoOwnMapForAPluginWithoutParametersAndMissesOneElse) {
    const std::string common =
        ", extent: [1 m, 1 m, 1 m], fixed: bottom, layers: [{name: a, youngs_modulus: 1 Pa, poisson_ratio: 0}]}";
    EXPECT_TRUE(complaints({{"tissue", "{type: half_space" + common}}).empty());
    const Messages expected{
        "--set tissue: tissue.lattice.cells: found nothing, wanted a list of three [x, y, z], each a number without a unit "
        "(number of "
        "cells along x, y, z)"};
    EXPECT_EQ(complaints({{"tissue", "{type: lattice" + common}}), expected);
}

TEST(GoodScene, RecordsEveryColumnWhereItNamesNone) {
    const Folder folder;
    std::string text = contents(good_scene());
    text.resize(text.find("record:"));
    folder.write("scene.yaml", text);
    folder.write("hands/steady.csv", "");
    EXPECT_EQ(read_scene(folder.path() / "scene.yaml", {}, good_plugins()).record.size(), all_columns().size());
}

TEST(GoodScene, HasItsTitleForAList) {
    EXPECT_EQ(scene_title(good_scene()), "A needle for tests");
    EXPECT_EQ(scene_title("no/such/file.yaml"), "");
    EXPECT_EQ(scene_title(std::filesystem::path(SCENES) / "hands/steady.csv"), "");
}

TEST(SceneHash, IsTheSameForTheSameSceneWhereverItLies) {
    const Folder folder;
    folder.write("scene.yaml", contents(good_scene()));
    folder.write("hands/steady.csv", contents(std::filesystem::path(SCENES) / "hands/steady.csv"));
    const Scene copy = read_scene(folder.path() / "scene.yaml", {}, good_plugins());
    EXPECT_EQ(copy.hash, good().hash);
    EXPECT_EQ(copy.hash.size(), 40u);
}

TEST(SceneHash, ChangesWithTheTextAnOverrideAndANamedFile) {
    const Folder folder;
    folder.write("scene.yaml", contents(good_scene()) + "# a remark\n");
    folder.write("hands/steady.csv", contents(std::filesystem::path(SCENES) / "hands/steady.csv"));
    const auto hash = [&] { return read_scene(folder.path() / "scene.yaml", {}, good_plugins()).hash; };
    const std::string with_remark = hash();
    EXPECT_NE(with_remark, good().hash);
    EXPECT_NE(good({{"run.rate", "2 kHz"}}).hash, good().hash);
    folder.write("hands/steady.csv", "other bytes");
    EXPECT_NE(hash(), with_remark);
}

TEST(SceneFiles, MayBeSharedWithinAFolderNamedScenes) {
    const Folder folder;
    std::string text = contents(good_scene());
    text.replace(text.find("hands/steady"), 12, "../hands/steady");
    folder.write("scenes/paper/scene.yaml", text);
    folder.write("scenes/hands/steady.csv", "");
    const Scene scene = read_scene(folder.path() / "scenes/paper/scene.yaml", {}, good_plugins());
    EXPECT_EQ(scene.device->parameters.text("file"),
              (std::filesystem::canonical(folder.path()) / "scenes/hands/steady.csv").string());
}

TEST(SceneFiles, MayNotLeaveTheTreeThroughALink) {
    const Folder folder;
    folder.write("tree/scene.yaml", contents(good_scene()));
    folder.write("outside/steady.csv", "");
    std::filesystem::create_directory_symlink(folder.path() / "outside", folder.path() / "tree/hands");
    const std::string file = (folder.path() / "tree/scene.yaml").string();
    try {
        (void)read_scene(file, {}, good_plugins());
        FAIL() << "a file outside the scene's tree was read";
    } catch (const SceneErrors& errors) {
        const Messages expected{
            file +
            ":25:9: device.file: found 'hands/steady.csv', which leaves the scene's folder tree, wanted the name of a "
            "file inside the scene's folder tree (a table of poses; left out, the motion counts)"};
        EXPECT_EQ(errors.messages(), expected);
    }
}

}    // namespace
}    // namespace stylet::core
