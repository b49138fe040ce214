// Loads a plugin's library and makes its objects, the way core does but without core.
#pragma once

#include <stylet/buckling_model.h>
#include <stylet/force_model.h>
#include <stylet/haptic_device.h>
#include <stylet/needle_model.h>
#include <stylet/tissue_model.h>

#include <initializer_list>
#include <memory>
#include <string>
#include <utility>

namespace stylet::contract {

/// Parameters that can be written in braces: {{"per_length", 5.0}, {"layer", "gel"}}.
struct Given : Parameters {
    Given() = default;
    Given(std::initializer_list<std::pair<std::string, Value>> values) {
        for (const auto& [name, value] : values) set(name, value);
    }
};

/// A block of one soft layer, wide and deep enough that its sides do not matter.
[[nodiscard]] inline TissueSetup gel_block() {
    return {.extent = Vector3(0.4, 0.4, 0.15),
            .fixed = "bottom",
            .layers = {{.name = "gel", .youngs_modulus = 25e3, .poisson_ratio = 0.49, .density = 1000.0, .thickness = 0.15}}};
}

/// The needle of the paper's Fig. 10: 200 mm of steel, 0.3 mm in radius, its tip held by the dent that it made.
[[nodiscard]] inline NeedleSetup steel_needle() {
    return {.length = 0.2, .radius = 0.3e-3, .youngs_modulus = 200e9, .ends = Ends::clamped_pinned};
}

/// What a plugin is made from and how hard the checks press it.
struct Case {
    std::string name = "Default";    // letters and digits
    Given parameters{};
    TissueSetup tissue = gel_block();
    NeedleSetup needle = steel_needle();
    bool has_tissue = true, has_needle = true;    // what the scene of an effect leaves out
    const BucklingModel* buckling = nullptr;      // lives as long as the tests
    double dt = 1e-3;                             // [s]
    double depth = 0.03;                          // [m] how deep the tip is in the checks that are inside the tissue
    double load = 0.5;                            // [N] on the tip, against the insertion; each shaft contact gets a tenth
    double lateral = 0.01;                        // of the load that acts across the needle
    int steps = 64;                               // in which a load is raised where its work is summed
    double tangent = 0.0;    // of the largest compliance, what a body that iterates with an older tangent may be off by
};

/// The descriptor that the library in `file` exports. The library stays loaded until the process ends.
/// Throws Error where there is no such library, or none with a descriptor.
[[nodiscard]] const Descriptor& load(const std::string& file);

/// A plugin object of the case, which outlives it where the plugin keeps what it was given. Throws what the plugin's constructor
/// throws.
[[nodiscard]] inline std::unique_ptr<Object> make(const Descriptor& plugin, const Case& with) {
    const Setup setup{.parameters = with.parameters,
                      .tissue = with.has_tissue ? &with.tissue : nullptr,
                      .needle = with.has_needle ? &with.needle : nullptr,
                      .buckling = with.buckling,
                      .dt = with.dt,
                      .workers = one_thread()};
    return std::unique_ptr<Object>(plugin.create(setup));
}

/// The same as its role, for a plugin's own tests: `const auto needle = make<NeedleModel>(STYLET_PLUGIN_FILE, with);`
template <class RoleType>
[[nodiscard]] std::unique_ptr<RoleType> make(const std::string& file, const Case& with) {
    const Descriptor& plugin = load(file);
    if (plugin.role != RoleType::role) throw Error("the library " + file + " is of another role than the test asked for");
    return std::unique_ptr<RoleType>(static_cast<RoleType*>(make(plugin, with).release()));
}

}    // namespace stylet::contract
