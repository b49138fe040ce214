// The settings that series stand for.
#include "apps/study/settings.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace stylet::study {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

Study study_of(const std::vector<Vary>& vary, const std::string& fitted) {
    Study study;
    study.changes = {{.key = "run.rate", .value = "9 Hz"}};
    study.series = {{.name = "rod", .scene = "scene.yaml", .changes = {}, .vary = vary}};
    study.fit_order = fitted;
    return study;
}

Vary vary(const std::string& key, const std::vector<std::string>& values, const std::string& label) {
    return {.key = key, .values = values, .label = label, .given = "study.yaml:1:1: " + key};
}

TEST(Settings, AreEveryCombinationTheLastKeyFirst) {
    std::vector<std::string> names;
    for (const Setting& setting :
         settings_of(study_of({vary("a", {"1", "2"}, "a {}"), vary("b", {"\"x\"", "[1, 2]"}, "{}")}, "")))
        names.push_back(setting.name());
    EXPECT_THAT(names, ElementsAre("rod, a 1, x", "rod, a 1, 1×2", "rod, a 2, x", "rod, a 2, 1×2"));
}

TEST(Settings, AVariedKeyTakesThePlaceOfTheStudys) {
    const auto settings = settings_of(study_of({vary("run.rate", {"\"1 kHz\""}, "{}")}, ""));
    ASSERT_EQ(settings.front().changes.size(), 1u);
    EXPECT_EQ(settings.front().changes.front().value, "\"1 kHz\"");
}

TEST(Settings, OrdersAreFittedInOneUnit) {
    std::vector<double> numbers;
    for (const Setting& setting : settings_of(study_of({vary("run.rate", {"250 Hz", "1 kHz", "4 kHz"}, "{}")}, "run.rate")))
        numbers.push_back(*setting.fitted);
    EXPECT_THAT(numbers, ElementsAre(250.0, 1000.0, 4000.0));
}

TEST(Settings, NoOrderIsFittedInWords) {
    try {
        (void)settings_of(study_of({vary("needle.type", {"rod", "rigid"}, "{}")}, "needle.type"));
        FAIL() << "nothing was thrown";
    } catch (const core::SceneErrors& errors) {
        EXPECT_THAT(errors.messages().front(), HasSubstr("wanted numbers of one dimension where an order is fitted"));
    }
}

}    // namespace
}    // namespace stylet::study
