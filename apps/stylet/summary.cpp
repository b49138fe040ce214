#include "apps/stylet/summary.h"

#include "apps/stylet/table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace stylet::app {
namespace {

using Align = Table::Align;

std::string quantity(double value, int decimals, const char* unit) {
    if (!std::isfinite(value)) return value > 0.0 ? "unlimited" : "none";
    const double last_digit = std::pow(10.0, -decimals);
    const double shown = std::abs(value) < last_digit / 2.0 ? 0.0 : value;    // never "-0.00"
    return fmt::format("{:.{}f} {}", shown, decimals, unit);
}

std::string seconds(double s) {
    return quantity(s, 3, "s");
}
std::string millimetres(double m) {
    return quantity(m * 1e3, 2, "mm");
}
std::string newtons(double n) {
    return quantity(n, 3, "N");
}
std::string millijoules(double j) {
    return quantity(j * 1e3, 4, "mJ");
}
std::string microseconds(double us) {
    return quantity(us, 1, "µs");
}

std::string events_text(const core::RunReport& report) {
    if (report.events.empty()) return "  no events\n";
    Table table({Align::left, Align::right, Align::right, Align::right, Align::right});
    table.add({"event", "time", "travel", "depth", "hand force"});
    for (const core::EventReport& event : report.events) {
        table.add(
            {event.name, seconds(event.time), millimetres(event.travel), millimetres(event.depth), newtons(event.hand_force)});
    }
    return table.text(2);
}

std::string findings_text(const core::RunReport& report) {
    Table table({Align::left, Align::left});
    table.add({"peak hand force", newtons(report.peak_hand_force)});
    if (report.buckling.empty()) table.add({"buckled", "never"});
    for (const core::BucklingReport& buckling : report.buckling) {
        table.add({"buckled", fmt::format("at {} (critical load {}), after {}", newtons(buckling.force),
                                          newtons(buckling.critical_load), seconds(buckling.time))});
    }
    table.add({"largest bow", millimetres(report.largest_deflection)});
    return table.text(2);
}

std::string ledger_text(const core::LedgerReport& ledger) {
    const core::Sample& totals = ledger.totals;
    Table table({Align::left, Align::right});
    table.add({"hand work", millijoules(totals.hand_work)});
    table.add({"= stored", millijoules(totals.stored)});
    table.add({"+ kinetic", millijoules(totals.kinetic)});
    table.add({"+ fracture", millijoules(totals.fracture)});
    table.add({"+ friction", millijoules(totals.friction)});
    table.add({"+ burst", millijoules(totals.burst)});
    table.add({"+ released", millijoules(totals.released)});
    table.add({"+ damping", millijoules(totals.damping)});
    table.add({"+ numerical", millijoules(totals.numerical)});
    table.add({"+ residual", millijoules(totals.residual)});
    return "  energy ledger\n" + table.text(4) +
           fmt::format("    largest residual on the way: {:.1e} of the peak work, {:.1e} until the first puncture\n",
                       ledger.relative, ledger.relative_pushing);
}

std::string hand_text(const std::optional<core::HandReport>& hand) {
    if (!hand) return "";
    const core::ForceChainCounts& chain = hand->force_chain;
    Table table({Align::left, Align::left});
    table.add({"force chain", fmt::format("soft start {}, magnitude {}, slew {}, stale {}, not finite {} ticks", chain.soft_start,
                                          chain.magnitude, chain.slew, chain.stale, chain.not_finite)});
    table.add({"passivity",
               fmt::format("the device was never given back more than {}", quantity(-hand->least_port_energy * 1e6, 3, "µJ"))});
    return table.text(2) + "\n";
}

/// "pictures/fig9_tissue.pvd, …_needle.pvd (201 moments, 0.04 s apart)"
std::string series_text(const FinishedSeries& series) {
    std::vector<std::string> names;
    for (const std::filesystem::path& file : series.files) {
        const std::string name = file.filename().string();
        names.push_back(names.empty() ? file.string() : "…" + name.substr(name.rfind('_')));
    }
    return fmt::format("{} ({} moment{}, {:g} s apart)", fmt::join(names, ", "), series.moments, series.moments == 1 ? "" : "s",
                       series.period);
}

std::string cost_text(const FinishedRun& run) {
    const core::RunReport& report = run.report;
    Table table({Align::left, Align::left});
    table.add({"tick", fmt::format("median {}, p99 {}, worst {}", microseconds(report.tick_us.median),
                                   microseconds(report.tick_us.p99), microseconds(report.tick_us.max))});
    table.add({"simulated", fmt::format("{} in {} ticks", seconds(report.duration), report.ticks)});
    table.add({"recording", run.recording});
    if (run.series) table.add({"series", series_text(*run.series)});
    return table.text(2);
}

}    // namespace

std::string summary_text(const FinishedRun& run) {
    return fmt::format("{}\n  scene {}\n\n{}\n{}\n{}\n{}{}", run.report.title, run.scene, events_text(run.report),
                       findings_text(run.report), ledger_text(run.report.ledger), hand_text(run.report.hand), cost_text(run));
}

bool ended_in_fault(const core::RunReport& report) {
    return std::any_of(report.events.begin(), report.events.end(),
                       [](const core::EventReport& event) { return event.name.starts_with("fault"); });
}

}    // namespace stylet::app
