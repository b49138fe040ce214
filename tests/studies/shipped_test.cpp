// The studies that come with Stylet: each is sound, and the page that is kept of it is of the study as it stands.
#include "apps/study/plan.h"
#include "apps/study/study_reader.h"
#include "apps/study/wording.h"
#include "core/scene/scene_files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>
#include <limits>
#include <sstream>

namespace stylet::study {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAreArray;
using testing::HasSubstr;

/// The first two cells of each row of a study's CSV, as a setting's name.
std::vector<std::string> settings_in(const std::string& csv) {
    std::vector<std::string> names;
    std::istringstream stream(csv);
    for (std::string line; std::getline(stream, line);) {
        if (line.starts_with("#") || line.starts_with("series,")) continue;
        std::vector<std::string> cells{""};
        bool quoted = false;
        for (const char c : line) {
            quoted = quoted != (c == '"');
            if (c == ',' && !quoted) {
                cells.emplace_back();
            } else if (c != '"') {
                cells.back() += c;
            }
        }
        names.push_back(cells[1].empty() ? cells[0] : cells[0] + ", " + cells[1]);
    }
    return names;
}

class Shipped : public testing::TestWithParam<std::string> {
protected:
    [[nodiscard]] static fs::path file() { return fs::path(SCENE_FOLDER) / "studies" / (GetParam() + ".yaml"); }
    [[nodiscard]] static fs::path page(const char* ending) { return fs::path(PAGE_FOLDER) / (GetParam() + ending); }
    [[nodiscard]] static std::string text(const char* ending) {
        return core::read_bytes(page(ending), std::numeric_limits<std::size_t>::max());
    }
};

TEST_P(Shipped, StudyIsSoundAndItsPageIsOfIt) {
    const core::PluginFolders folders = core::PluginFolders::standard({PLUGIN_FOLDER});
    const Study study = read_study(file(), folders);
    const Plan plan = plan_of(study, folders, "a processor");
    std::printf("%s: %zu settings, %zu cases, %zu things to measure\n", study.title.c_str(), plan.settings.size(),
                study.cases.size(), plan.jobs.size());

    std::vector<std::string> names;
    for (const Setting& setting : plan.settings) names.push_back(setting.name());
    const std::string csv = text(".csv"), markdown = text(".md");
    EXPECT_THAT(settings_in(csv), ElementsAreArray(names));
    EXPECT_THAT(csv, HasSubstr("# measured: " + measure_words(study.measure) + "\n"));
    EXPECT_THAT(csv, HasSubstr("# reference: " + reference_words(study) + "\n"));
    EXPECT_THAT(csv, HasSubstr("# scene: " + scenes_words(study) + "\n"));
    EXPECT_THAT(markdown, HasSubstr("# " + study.title + "\n"));
    ASSERT_FALSE(study.question.empty());
    EXPECT_THAT(markdown, HasSubstr(study.question));
    EXPECT_THAT(markdown, HasSubstr("stylet study scenes/studies/" + GetParam() + ".yaml --out docs/studies\n"));
    for (const char* picture : {".png", ".svg"}) EXPECT_TRUE(fs::exists(page(picture))) << page(picture);
}

std::vector<std::string> shipped() {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(fs::path(SCENE_FOLDER) / "studies")) {
        if (entry.path().extension() == ".yaml") names.push_back(entry.path().stem().string());
    }
    return names;
}

INSTANTIATE_TEST_SUITE_P(All, Shipped, testing::ValuesIn(shipped()), [](const auto& study) { return study.param; });

}    // namespace
}    // namespace stylet::study
