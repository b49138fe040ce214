// The contract: the tests that every plugin of a role must pass, run on the plugin's built library. A plugin's test names the
// cases:
//
//     using stylet::contract::Case;
//     STYLET_CONTRACT(Case{.name = "Gel", .parameters = {{"rupture_force", 1.0}, {"toughness", 164.0}}})
//
// which adds one test per check and case, EffectContract.AddsOnlyNonNegativeLimits/Gel and so on; the role is the library's own.
#pragma once

#include <stylet/contract/plugin.h>

#include <gtest/gtest.h>

#include <span>
#include <vector>

namespace stylet::contract {

/// One promise of a role, tested on one case. Uses GoogleTest's expectations; a plugin that throws fails.
struct Check {
    const char* name;
    void (*run)(const Descriptor& plugin, const Case& with);
};

/// What every plugin of this role must keep.
[[nodiscard]] std::vector<Check> checks_of(Role role);

/// Registers the checks of the role of the plugin in `file`, each for every case. A library that cannot be loaded is a failing
/// test.
bool add(const char* file, std::vector<Case> cases);

}    // namespace stylet::contract

#define STYLET_CONTRACT(...) static const bool stylet_contract_added = ::stylet::contract::add(STYLET_PLUGIN_FILE, {__VA_ARGS__});
