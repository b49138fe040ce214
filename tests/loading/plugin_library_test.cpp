#include "core/loading/plugin_library.h"

#include "test_scenes.h"

#include <gtest/gtest.h>

namespace stylet::core {
namespace {

std::string refusal(const std::string& type, const PluginFolders& folders) {
    try {
        (void)PluginLibrary::open(type, folders);
        return "";
    } catch (const Error& error) {
        return error.what();
    }
}
std::string refusal(const std::string& type) {
    return refusal(type, bad_plugins());
}

TEST(PluginLibrary, GivesTheDescriptorOfAGoodPlugin) {
    const PluginLibrary library = PluginLibrary::open("fracture", Role::effect, good_plugins());
    EXPECT_STREQ(library.descriptor().name, "fracture");
    EXPECT_EQ(library.descriptor().parameter_count, 2u);
    EXPECT_STREQ(library.descriptor().parameters[1].unit, "J/m^2");
    EXPECT_EQ(library.file(), std::filesystem::path(GOOD_PLUGINS) / "fracture.so");
}

TEST(PluginLibrary, IsMappedOnlyWhileItIsOpen) {
    {
        const PluginLibrary library = PluginLibrary::open("friction", good_plugins());
        EXPECT_TRUE(is_mapped("friction"));
    }
    EXPECT_FALSE(is_mapped("friction"));
}

TEST(PluginLibrary, SaysWhichRoleAPluginHasAndWhichWasWanted) {
    try {
        (void)PluginLibrary::open("friction", Role::tissue, good_plugins());
        FAIL() << "an effect was taken for a tissue";
    } catch (const Error& error) {
        EXPECT_STREQ(error.what(), "'friction' is an effect, wanted a tissue");
    }
}

TEST(PluginLibrary, RefusesAnotherSdkVersion) {
    EXPECT_EQ(refusal("other_sdk"), "plugin 'other_sdk' was built for SDK version " + std::to_string(sdk_version + 1) +
                                        ", this program has " + std::to_string(sdk_version) + ": rebuild it");
}

TEST(PluginLibrary, RefusesAnotherDescriptorSize) {
    const std::size_t size = sizeof(Descriptor);
    EXPECT_EQ(refusal("other_size"), "plugin 'other_size' was built with a descriptor of " + std::to_string(size + 8) +
                                         " bytes, this program's has " + std::to_string(size) + ": rebuild it");
}

TEST(PluginLibrary, RefusesAnotherEigenVersion) {
    EXPECT_EQ(refusal("other_eigen"),
              "plugin 'other_eigen' was built with Eigen 3.3.9, this program with " STYLET_TEXT(
                  EIGEN_WORLD_VERSION) "." STYLET_TEXT(EIGEN_MAJOR_VERSION) "." STYLET_TEXT(EIGEN_MINOR_VERSION) ": rebuild it");
}

TEST(PluginLibrary, RefusesAnotherAlignment) {
    const unsigned ours = EIGEN_MAX_STATIC_ALIGN_BYTES;
    EXPECT_EQ(refusal("other_alignment"), "plugin 'other_alignment' was built for an Eigen alignment of " +
                                              std::to_string(2 * ours) + " bytes, this program has " + std::to_string(ours) +
                                              " (compiler flags such as -mavx change it): rebuild it");
}

TEST(PluginLibrary, RefusesAnotherCompiler) {
    EXPECT_EQ(refusal("other_compiler"),
              "plugin 'other_compiler' was built by another compiler 1, this program by " STYLET_COMPILER ": rebuild it");
}

TEST(PluginLibrary, RefusesAnotherStandardLibrary) {
    EXPECT_EQ(refusal("other_library"),
              "plugin 'other_library' was built with another library, this program with " STYLET_LIBRARY ": rebuild it");
}

TEST(PluginLibrary, RefusesANameThatIsNotItsFiles) {
    EXPECT_EQ(
        refusal("other_name"),
        "the library other_name.so calls its plugin 'somebody_else', wanted 'other_name': a library bears its plugin's name");
}

TEST(PluginLibrary, RefusesADescriptorWithPartsLeftOut) {
    EXPECT_EQ(refusal("incomplete"), "plugin 'incomplete' has a descriptor with parts left out");
}

TEST(PluginLibrary, RefusesALibraryWithoutADescriptor) {
    EXPECT_EQ(refusal("no_descriptor"), "the library no_descriptor.so is no plugin: it exports no stylet_plugin");
}

TEST(PluginLibrary, RefusesALibraryWithAnUndefinedSymbol) {
    const std::string message = refusal("undefined_symbol");
    EXPECT_TRUE(message.starts_with("cannot open plugin 'undefined_symbol': undefined symbol: ")) << message;
    EXPECT_NE(message.find("defined_nowhere"), std::string::npos) << message;
}

TEST(PluginLibrary, RefusesATextFile) {
    const std::string message = refusal("text_file");
    EXPECT_TRUE(message.starts_with("cannot open plugin 'text_file': ")) << message;
    EXPECT_EQ(message.find('/'), std::string::npos) << "a path, or the wrapping of a library: " << message;
}

TEST(PluginLibrary, LeavesNothingMappedOfWhatItRefused) {
    for (const char* type : {"other_sdk", "other_name", "no_descriptor"}) {
        EXPECT_NE(refusal(type), "");
        EXPECT_FALSE(is_mapped(type)) << type;
    }
}

TEST(PluginLibrary, SaysWhereItLookedAndWhatMayHaveBeenMeant) {
    EXPECT_EQ(refusal("fricton", PluginFolders({"/nowhere", GOOD_PLUGINS})),
              std::string("found no plugin 'fricton' in /nowhere, ") + GOOD_PLUGINS + "; did you mean 'friction'?");
}

TEST(PluginLibrary, RefusesAPathForAName) {
    EXPECT_EQ(refusal("../friction", good_plugins()),
              "found '../friction', wanted a plugin's name (small letters, digits and '_')");
}

}    // namespace
}    // namespace stylet::core
