// What one tick leaves behind for a recording.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace stylet::core {

/// One tick's numbers. `hand_force` is the base reaction along the needle, positive in compression.
struct Sample {
    double time = 0.0;                    // [s]
    double travel = 0.0;                  // [m] way of the base along the needle since the start
    double depth = 0.0;                   // [m] of the tip below the undeformed surface
    double inserted = 0.0;                // [m] track that the tip has behind it
    double hand_force = 0.0;              // [N] what the simulation asks for
    double device_force = 0.0;            // [N] what the force chain lets through
    double tip_force = 0.0;               // [N]
    double friction_force = 0.0;          // [N] all shaft contacts, along the needle
    double critical_load = 0.0;           // [N]
    double deflection = 0.0;              // [m]
    double free_length = 0.0;             // [m]
    double contacts = 0.0;                // number of shaft contacts
    double patch_displacement = 0.0;      // [m] mean of the loaded patches, along their forces
    double energy_force = 0.0;            // [N] Eq. (7) with friction, burst, released and numerical terms
    double energy_force_printed = 0.0;    // [N] Eq. (7) as the paper prints it
    double port_energy = 0.0;             // [J] that the device has put into the simulation
    double hand_work = 0.0;               // [J] totals from here on
    double load_work = 0.0;               // [J]
    double stored = 0.0;                  // [J]
    double kinetic = 0.0;                 // [J]
    double fracture = 0.0;                // [J]
    double friction = 0.0;                // [J]
    double burst = 0.0;                   // [J]
    double released = 0.0;                // [J]
    double damping = 0.0;                 // [J]
    double numerical = 0.0;               // [J]
    double residual = 0.0;                // [J]
};

/// A column of a recording: its name, its unit, where it lives in a Sample, what it means, and what a scene without needle or
/// tissue has no use for.
struct Column {
    enum class Of { scene, needle, tissue, both };
    const char* name;
    const char* unit;
    double Sample::*value;
    const char* meaning;
    Of of = Of::scene;
};

/// Whether a scene with these parts has this column.
[[nodiscard]] constexpr bool there(const Column& column, bool needle, bool tissue) {
    const bool wants_needle = column.of == Column::Of::needle || column.of == Column::Of::both;
    const bool wants_tissue = column.of == Column::Of::tissue || column.of == Column::Of::both;
    return (needle || !wants_needle) && (tissue || !wants_tissue);
}

/// Every column there is, in the order of Sample.
[[nodiscard]] std::span<const Column> all_columns();

/// nullptr where there is none of this name.
[[nodiscard]] const Column* column_named(std::string_view name);

/// The columns that a scene's `record` names; "ledger" stands for all the energies. `time` always comes first.
[[nodiscard]] std::vector<Column> columns_of(const std::vector<std::string>& record);

/// Words that `record` may hold: every column's name and the group "ledger".
[[nodiscard]] std::vector<std::string> record_words();

}    // namespace stylet::core
