#include "core/run/sample.h"

#include <algorithm>
#include <array>

namespace stylet::core {
namespace {

constexpr std::array columns{
    Column{"time", "s", &Sample::time, "since the start"},
    Column{"travel", "m", &Sample::travel, "way of the base along the needle since the start", Column::Of::needle},
    Column{"depth", "m", &Sample::depth, "of the tip below the undeformed surface", Column::Of::both},
    Column{"inserted", "m", &Sample::inserted, "track that the tip has behind it", Column::Of::both},
    Column{"hand_force", "N", &Sample::hand_force, "base reaction along the needle, positive in compression", Column::Of::needle},
    Column{"device_force", "N", &Sample::device_force, "what the force chain lets through to the hand", Column::Of::needle},
    Column{"tip_force", "N", &Sample::tip_force, "on the tip, along the needle", Column::Of::needle},
    Column{"friction_force", "N", &Sample::friction_force, "of all shaft contacts, along the needle", Column::Of::both},
    Column{"critical_load", "N", &Sample::critical_load, "of the free length", Column::Of::needle},
    Column{"deflection", "m", &Sample::deflection, "largest distance of the needle from the straight line", Column::Of::needle},
    Column{"free_length", "m", &Sample::free_length, "from the base to where the track takes hold of the shaft",
           Column::Of::needle},
    Column{"contacts", "1", &Sample::contacts, "number of shaft contacts", Column::Of::both},
    Column{"patch_displacement", "m", &Sample::patch_displacement, "mean of the loaded patches, along their forces",
           Column::Of::tissue},
    Column{"energy_force", "N", &Sample::energy_force, "Eq. (7) with friction, burst, released and numerical terms",
           Column::Of::both},
    Column{"energy_force_printed", "N", &Sample::energy_force_printed, "Eq. (7) as the paper prints it", Column::Of::both},
    Column{"port_energy", "J", &Sample::port_energy, "that the device has put into the simulation, by what it felt",
           Column::Of::needle},
    Column{"hand_work", "J", &Sample::hand_work, "work of the hand", Column::Of::needle},
    Column{"load_work", "J", &Sample::load_work, "work of prescribed loads"},
    Column{"stored", "J", &Sample::stored, "elastic energy of both bodies, since the start"},
    Column{"kinetic", "J", &Sample::kinetic, "kinetic energy of both bodies, since the start"},
    Column{"fracture", "J", &Sample::fracture, "consumed by new track"},
    Column{"friction", "J", &Sample::friction, "lost along the shaft"},
    Column{"burst", "J", &Sample::burst, "surplus at ruptures"},
    Column{"released", "J", &Sample::released,
           "set free by contact points that moved on; negative where a growing contact overstates its slip"},
    Column{"damping", "J", &Sample::damping, "lost to declared damping"},
    Column{"numerical", "J", &Sample::numerical, "lost to the integrator"},
    Column{"residual", "J", &Sample::residual, "what the ledger cannot account for"},
};

constexpr std::string_view ledger = "ledger";
constexpr std::size_t first_energy = 16;    // hand_work; the energies run to the end
static_assert(std::string_view(columns[first_energy].name) == "hand_work");
static_assert(sizeof(Sample) == columns.size() * sizeof(double), "a number of Sample has no column");

}    // namespace

std::span<const Column> all_columns() {
    return columns;
}

const Column* column_named(std::string_view name) {
    const auto found = std::ranges::find(columns, name, [](const Column& column) { return std::string_view(column.name); });
    return found == columns.end() ? nullptr : &*found;
}

std::vector<Column> columns_of(const std::vector<std::string>& record) {
    std::vector<Column> chosen{columns.front()};
    const auto choose = [&](const Column& column) {
        if (std::ranges::find(chosen, column.value, &Column::value) == chosen.end()) chosen.push_back(column);
    };
    for (const std::string& word : record) {
        for (const Column& column : columns) {
            const bool energy = &column >= &columns[first_energy];
            if (word == column.name || (word == ledger && energy)) choose(column);
        }
    }
    return chosen;
}

std::vector<std::string> record_words() {
    std::vector<std::string> words;
    words.reserve(std::size(columns) + 1);
    for (const Column& column : columns) words.emplace_back(column.name);
    words.emplace_back(ledger);
    return words;
}

}    // namespace stylet::core
