// What becomes of a key that is changed more than once.
#include "apps/study/changes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace stylet::study {
namespace {

using core::Override;
using testing::ElementsAre;

Override set(const std::string& key, const std::string& value) {
    return {.key = key, .value = value};
}
Override take_out(const std::string& key) {
    return {.key = key, .value = "", .given = "", .removes = true};
}

std::vector<std::string> words(const std::vector<Override>& changes) {
    std::vector<std::string> words;
    for (const Override& change : changes) words.push_back(change.removes ? "-" + change.key : change.key + "=" + change.value);
    return words;
}

TEST(Changes, LaterOnesWin) {
    EXPECT_THAT(words(joined({set("a.b", "1"), set("c", "1")}, {set("a.b", "2")})), ElementsAre("a.b=2", "c=1"));
    EXPECT_THAT(words(joined({}, {set("a", "1"), set("a", "2")})), ElementsAre("a=2"));
}

TEST(Changes, AWholeMapOrListTakesThePlaceOfWhatWasChangedWithinIt) {
    EXPECT_THAT(words(joined({set("a.b", "1"), set("a.b.c", "1"), set("ab", "1")}, {set("a", "{}")})),
                ElementsAre("a={}", "ab=1"));
    EXPECT_THAT(words(joined({set("e[1].f", "1"), take_out("e[0]")}, {set("e", "[]")})), ElementsAre("e=[]"));
    EXPECT_THAT(words(joined({set("e[1].f", "1")}, {take_out("e[1]")})), ElementsAre("-e[1]"));
}

TEST(Changes, WhatIsChangedWithinALaterMapComesAfterIt) {
    EXPECT_THAT(words(joined({set("a", "{}")}, {set("a.b", "1")})), ElementsAre("a={}", "a.b=1"));
    EXPECT_THAT(words(joined({take_out("a.b")}, {set("a", "{}")})), ElementsAre("a={}"));
}

TEST(Changes, LookAlikeInWhateverOrderTheyCome) {
    std::vector<Override> one, other;
    for (char c = 'a'; c <= 'z'; ++c) one.push_back(set(std::string(1, c), "1"));
    other.assign(one.rbegin(), one.rend());
    EXPECT_EQ(words(joined({}, one)), words(joined({}, other)));
}

}    // namespace
}    // namespace stylet::study
