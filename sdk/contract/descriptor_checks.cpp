#include "checks.h"

#include <set>
#include <string_view>

namespace stylet::contract {
namespace {

bool says_something(const char* text) {
    return text != nullptr && *text != '\0';
}

bool has_dimension(Kind kind) {
    return kind == Kind::number || kind == Kind::vector3;
}

/// Only these come in steps from coarse to fine.
bool has_fineness(Kind kind) {
    return kind == Kind::number || kind == Kind::integer || kind == Kind::choice || kind == Kind::vector3;
}

void check_parameter(const Parameter& parameter) {
    ASSERT_TRUE(says_something(parameter.name));
    SCOPED_TRACE(parameter.name);
    EXPECT_TRUE(says_something(parameter.meaning));
    EXPECT_EQ(says_something(parameter.unit), has_dimension(parameter.kind))
        << "numbers and vectors have a unit, \"1\" where they have none";
    EXPECT_EQ(says_something(parameter.choices), parameter.kind == Kind::choice);
    EXPECT_EQ(parameter.field_count > 0, parameter.kind == Kind::records);
    EXPECT_TRUE(parameter.finer == Finer::neither || has_fineness(parameter.kind)) << "no step of it is finer than another";
    EXPECT_LE(parameter.range.least, parameter.range.greatest);
    for (std::uint32_t i = 0; i < parameter.field_count; ++i) check_parameter(parameter.fields[i]);
}

void says_what_it_is(const Descriptor& plugin, const Case&) {
    EXPECT_TRUE(says_something(plugin.name));
    EXPECT_TRUE(says_something(plugin.about.summary));
    EXPECT_TRUE(says_something(plugin.about.formula));
    EXPECT_TRUE(says_something(plugin.about.source)) << "author, year, equation";
    EXPECT_TRUE(says_something(plugin.about.validity));
    EXPECT_EQ(plugin.stamp.size, sizeof(Descriptor));
    EXPECT_EQ(plugin.stamp.sdk, sdk_version);
    EXPECT_EQ(plugin.stamp.alignment, build_stamp().alignment)
        << "[bytes] of Eigen: a flag such as -mavx, which the contract and the program were not built with";
    std::set<std::string_view> names;
    for (std::uint32_t i = 0; i < plugin.parameter_count; ++i) {
        check_parameter(plugin.parameters[i]);
        EXPECT_TRUE(names.insert(plugin.parameters[i].name).second) << plugin.parameters[i].name << " is declared twice";
    }
}

}    // namespace

std::vector<Check> descriptor_checks() {
    return {{"SaysWhatItIs", says_what_it_is}};
}

}    // namespace stylet::contract
