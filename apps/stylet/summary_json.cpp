#include "apps/stylet/summary.h"

#include <nlohmann/json.hpp>

#include <cmath>

namespace stylet::app {
namespace {

using nlohmann::ordered_json;

/// JSON has no infinity.
ordered_json number(double value) {
    return std::isfinite(value) ? ordered_json(value) : ordered_json(nullptr);
}

ordered_json vector(const Vector3& value) {
    return {number(value.x()), number(value.y()), number(value.z())};
}

ordered_json vectors(const std::vector<Vector3>& values) {
    ordered_json json = ordered_json::array();
    for (const Vector3& value : values) json.push_back(vector(value));
    return json;
}

/// What was loaded, and how it moved; null where nothing was.
ordered_json loads_json(const core::PatchReport& loads) {
    if (loads.patches.empty()) return nullptr;
    ordered_json patches = ordered_json::array();
    for (const core::LoadedPatch& loaded : loads.patches) {
        patches.push_back({{"effect", loaded.effect},
                           {"centre", vector(loaded.patch.centre)},
                           {"size", vector(loaded.patch.size)},
                           {"force", vectors(loaded.force)},
                           {"displacement", vectors(loaded.displacement)}});
    }
    return {{"times", loads.times}, {"patches", patches}};
}

ordered_json ledger_json(const core::LedgerReport& ledger) {
    const core::Sample& totals = ledger.totals;
    return {{"hand_work", number(totals.hand_work)},
            {"load_work", number(totals.load_work)},
            {"residual", number(totals.residual)},
            {"relative", number(ledger.relative)},
            {"relative_pushing", number(ledger.relative_pushing)},
            {"peak_work", number(ledger.peak_work)},
            {"stored", number(totals.stored)},
            {"kinetic", number(totals.kinetic)},
            {"fracture", number(totals.fracture)},
            {"friction", number(totals.friction)},
            {"burst", number(totals.burst)},
            {"released", number(totals.released)},
            {"damping", number(totals.damping)},
            {"numerical", number(totals.numerical)}};
}

}    // namespace

std::string summary_json(const FinishedRun& run) {
    const core::RunReport& report = run.report;
    ordered_json events = ordered_json::array();
    for (const core::EventReport& event : report.events) {
        events.push_back({{"name", event.name},
                          {"time", number(event.time)},
                          {"travel", number(event.travel)},
                          {"depth", number(event.depth)},
                          {"hand_force", number(event.hand_force)}});
    }
    ordered_json buckling = ordered_json::array();
    for (const core::BucklingReport& one : report.buckling) {
        buckling.push_back(
            {{"time", number(one.time)}, {"force", number(one.force)}, {"critical_load", number(one.critical_load)}});
    }
    ordered_json hand = nullptr;
    if (report.hand) {
        const core::ForceChainCounts& chain = report.hand->force_chain;
        hand = {{"soft_start_ticks", chain.soft_start},
                {"magnitude_ticks", chain.magnitude},
                {"slew_ticks", chain.slew},
                {"stale_ticks", chain.stale},
                {"fault_ticks", chain.fault},
                {"least_port_energy", number(report.hand->least_port_energy)},
                {"least_port_energy_without_hold", number(report.hand->least_port_energy_without_hold)}};
    }
    ordered_json real_time = nullptr;
    if (report.real_time) {
        const core::RealTimeReport& loop = *report.real_time;
        real_time = {{"scheduling", loop.scheduling},
                     {"memory", loop.memory},
                     {"wall_time", number(loop.wall_time)},
                     {"overruns", loop.overruns},
                     {"skipped", loop.skipped},
                     {"lost_rows", loop.lost_rows},
                     {"latency_us",
                      {{"upper_bounds", core::Latency::upper_bounds},
                       {"woke", loop.woke.counts()},
                       {"answered", loop.answered.counts()},
                       {"woke_worst", number(loop.woke.worst())},
                       {"answered_worst", number(loop.answered.worst())}}}};
    }
    const auto of_needle = [&report](double value) { return report.has_needle ? number(value) : ordered_json(nullptr); };
    const core::TickReport& tick = report.tick_us;
    ordered_json series = nullptr;
    if (run.series) {
        ordered_json files = ordered_json::array();
        for (const auto& file : run.series->files) files.push_back(file.string());
        series = {{"files", files}, {"moments", run.series->moments}, {"period", number(run.series->period)}};
    }
    const ordered_json json{{"title", report.title},
                            {"scene", run.scene},
                            {"hash", report.hash},
                            {"recording", run.recording},
                            {"series", series},
                            {"events", events},
                            {"unlisted_events", report.unlisted_events},
                            {"peak_hand_force", of_needle(report.peak_hand_force)},
                            {"largest_deflection", of_needle(report.largest_deflection)},
                            {"buckling", buckling},
                            {"ledger", ledger_json(report.ledger)},
                            {"loads", loads_json(report.loads)},
                            {"hand", hand},
                            {"real_time", real_time},
                            {"tick_us", {{"median", number(tick.median)}, {"p99", number(tick.p99)}, {"max", number(tick.max)}}},
                            {"stopped", report.stopped},
                            {"ticks", report.ticks},
                            {"lost_ticks", report.lost_ticks},
                            {"duration", number(report.duration)},
                            {"libraries", report.libraries}};
    return json.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

}    // namespace stylet::app
