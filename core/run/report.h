// What a whole run came to.
#pragma once

#include "core/device/force_chain.h"
#include "core/run/real_time_loop.h"
#include "core/run/sample.h"

#include <stylet/patch.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace stylet::core {

struct EventReport {
    std::string name;
    double time;          // [s]
    double travel;        // [m]
    double depth;         // [m]
    double hand_force;    // [N]
};

struct BucklingReport {
    double time;             // [s]
    double force;            // [N]
    double critical_load;    // [N]
};

struct LedgerReport {
    double peak_work = 0.0;           // [J] largest |hand work| or stored energy on the way
    double relative = 0.0;            // largest |residual| on the way, over peak_work
    double relative_pushing = 0.0;    // the same until the first puncture
    Sample totals;
};

/// What a hand at the device met.
struct HandReport {
    ForceChainCounts force_chain;                   // [ticks]
    double least_port_energy = 0.0;                 // [J] at most 0: what the simulation gave back beyond what it got
    double least_port_energy_without_hold = 0.0;    // [J] of that, what was not by holding each force until the next
};

/// A patch of the tissue's surface that an effect loads.
struct LoadedPatch {
    std::string effect;    // its path in the scene, for instance effects[1]
    Patch patch;
    std::vector<Vector3> force;           // [N] one for each time
    std::vector<Vector3> displacement;    // [m] mean of the patch, one for each time
};

struct PatchReport {
    std::vector<double> times;    // [s] of every tick; none where nothing is loaded
    std::vector<LoadedPatch> patches;
};

struct TickReport {
    double median = 0.0, p99 = 0.0, max = 0.0, mean = 0.0;    // [µs] wall time, after a warm-up
};

struct RunReport {
    std::string title;
    std::string hash;
    std::vector<EventReport> events;
    std::size_t unlisted_events = 0;    // more than a report has room for
    double peak_hand_force = 0.0;       // [N]
    double largest_deflection = 0.0;    // [m]
    std::vector<BucklingReport> buckling;
    LedgerReport ledger;
    std::optional<HandReport> hand;    // of a scene with a device
    PatchReport loads;
    bool has_needle = true, has_tissue = true;    // what the scene names
    TickReport tick_us;
    std::optional<RealTimeReport> real_time;    // of a run on the wall clock
    bool stopped = false;                       // before the scene was over
    std::size_t ticks = 0;
    std::size_t lost_ticks = 0;    // of them, those that found no equilibrium
    double duration = 0.0;         // [s]
    std::vector<std::string> libraries;
};

}    // namespace stylet::core
