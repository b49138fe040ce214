#include "core/run/sample.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace stylet::core {
namespace {

std::vector<std::string> names_of(const std::vector<Column>& columns) {
    std::vector<std::string> names;
    for (const Column& column : columns) names.emplace_back(column.name);
    return names;
}

TEST(Columns, BeginWithTimeAndKeepTheScenesOrder) {
    const std::vector<std::string> expected{"time", "hand_force", "depth"};
    EXPECT_EQ(names_of(columns_of({"hand_force", "depth", "time", "depth"})), expected);
}

TEST(Columns, OfTheLedgerAreAllTheEnergies) {
    const std::vector<std::string> expected{"time",     "hand_work", "load_work", "stored",  "kinetic",   "fracture",
                                            "friction", "burst",     "released",  "damping", "numerical", "residual"};
    EXPECT_EQ(names_of(columns_of({"ledger"})), expected);
    EXPECT_EQ(names_of(columns_of({"ledger", "residual"})), expected);
}

TEST(Columns, EachReadANumberOfTheirOwn) {
    Sample sample;
    double next = 1.0;
    for (const Column& column : all_columns()) sample.*(column.value) = next++;
    double expected = 1.0;
    for (const Column& column : all_columns()) EXPECT_EQ(sample.*(column.value), expected++) << column.name;
}

TEST(Columns, AreAllWordsForARecord) {
    const std::vector<std::string> words = record_words();
    EXPECT_EQ(words.size(), all_columns().size() + 1);
    EXPECT_EQ(words.back(), "ledger");
    for (const std::string& word : words) EXPECT_FALSE(columns_of({word}).empty());
}

}    // namespace
}    // namespace stylet::core
