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

/// Without its minus where all that is shown of it is zero.
std::string vector(const Vector3& value, const char* unit) {
    const auto shown = [](double x) { return std::abs(x) < 5e-4 ? 0.0 : x; };
    return fmt::format("({:.3f}, {:.3f}, {:.3f}) {}", shown(value.x()), shown(value.y()), shown(value.z()), unit);
}

std::string events_text(const core::RunReport& report) {
    if (report.events.empty()) return "  no events\n";
    const bool hand = report.hand.has_value(), both = report.has_needle && report.has_tissue;
    const auto add = [&](Table& table, const std::vector<std::string>& cells) {
        std::vector<std::string> row{cells[0], cells[1]};
        if (hand) row.push_back(cells[2]);
        if (both) row.push_back(cells[3]);
        if (report.has_needle) row.push_back(cells[4]);
        table.add(row);
    };
    Table table({Align::left, Align::right, Align::right, Align::right, Align::right});
    add(table, {"event", "time", "travel", "depth", hand ? "hand force" : "base force"});
    for (const core::EventReport& event : report.events) {
        add(table,
            {event.name, seconds(event.time), millimetres(event.travel), millimetres(event.depth), newtons(event.hand_force)});
    }
    const std::string rest = report.unlisted_events == 0 ? "" : fmt::format("  … and {} more\n", report.unlisted_events);
    return table.text(2) + rest;
}

std::string findings_text(const core::RunReport& report) {
    Table table({Align::left, Align::left});
    if (report.has_needle) {
        table.add({report.hand ? "peak hand force" : "peak base force", newtons(report.peak_hand_force)});
        if (report.buckling.empty()) table.add({"buckled", "never"});
    }
    for (const core::BucklingReport& buckling : report.buckling) {
        const std::string by_formula =    // a needle that needs no formula has none
            std::isfinite(buckling.critical_load) ? fmt::format(" (critical load {})", newtons(buckling.critical_load)) : "";
        table.add({"buckled", fmt::format("at {}{}, after {}", newtons(buckling.force), by_formula, seconds(buckling.time))});
    }
    if (report.has_needle) table.add({"largest bow", millimetres(report.largest_deflection)});
    for (const core::LoadedPatch& loaded : report.loads.patches) {
        if (loaded.force.empty()) continue;
        table.add(
            {"patch of " + loaded.effect, fmt::format("moved by {} under {}", vector(loaded.displacement.back() * 1e3, "mm"),
                                                      vector(loaded.force.back(), "N"))});
    }
    return table.text(2);
}

/// Only what the scene's parts can have a share in.
std::string ledger_text(const core::RunReport& report) {
    const core::LedgerReport& ledger = report.ledger;
    const core::Sample& totals = ledger.totals;
    const bool hand = report.hand.has_value(), both = report.has_needle && report.has_tissue;
    Table table({Align::left, Align::right});
    const auto add = [&table](bool there, const char* name, double energy) {
        if (there) table.add({name, millijoules(energy)});
    };
    add(hand, "hand work", totals.hand_work);
    add(!report.loads.patches.empty() || totals.load_work != 0.0, hand ? "+ load work" : "load work", totals.load_work);
    add(true, "= stored", totals.stored);
    add(true, "+ kinetic", totals.kinetic);
    add(both, "+ fracture", totals.fracture);
    add(both, "+ friction", totals.friction);
    add(both, "+ burst", totals.burst);
    add(both, "+ released", totals.released);
    add(true, "+ damping", totals.damping);
    add(true, "+ numerical", totals.numerical);
    add(true, "+ residual", totals.residual);
    const std::string pushing = both ? fmt::format(", {:.1e} until the first puncture", ledger.relative_pushing) : "";
    return "  energy ledger\n" + table.text(4) +
           fmt::format("    largest residual on the way: {:.1e} of the peak work{}\n", ledger.relative, pushing);
}

std::string hand_text(const std::optional<core::HandReport>& hand) {
    if (!hand) return "";
    const core::ForceChainCounts& chain = hand->force_chain;
    Table table({Align::left, Align::left});
    table.add({"force chain", fmt::format("soft start {}, magnitude {}, slew {}, stale {}, fault {} ticks", chain.soft_start,
                                          chain.magnitude, chain.slew, chain.stale, chain.fault)});
    table.add({"passivity", fmt::format("the device was given back at most {}, {} of it not by holding each force for a tick",
                                        quantity(-hand->least_port_energy * 1e6, 3, "µJ"),
                                        quantity(-hand->least_port_energy_without_hold * 1e6, 3, "µJ"))});
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

std::string upper_bound(std::size_t bin) {
    const auto& bounds = core::Latency::upper_bounds;
    return bin < bounds.size() ? fmt::format("< {:g} µs", bounds[bin]) : fmt::format("≥ {:g} µs", bounds.back());
}

std::string real_time_text(const std::optional<core::RealTimeReport>& run) {
    if (!run) return "";
    Table grants({Align::left, Align::left});
    grants.add({"scheduling", run->scheduling});
    grants.add({"memory", run->memory});
    grants.add({"wall clock", seconds(run->wall_time)});
    grants.add({"overruns", fmt::format("{} ticks, {} periods given up, {} rows of the recording lost", run->overruns,
                                        run->skipped, run->lost_rows)});
    grants.add({"worst", fmt::format("woke {} after its deadline, device answered {} after it", microseconds(run->woke.worst()),
                                     microseconds(run->answered.worst()))});
    Table bins({Align::right, Align::right, Align::right});
    bins.add({"after the deadline", "woke", "device answered"});
    for (std::size_t bin = 0; bin < core::Latency::bins; ++bin) {
        const std::size_t woke = run->woke.counts()[bin], answered = run->answered.counts()[bin];
        if (woke + answered > 0) bins.add({upper_bound(bin), std::to_string(woke), std::to_string(answered)});
    }
    return "  real time\n" + grants.text(4) + bins.text(4) + "\n";
}

std::string cost_text(const FinishedRun& run) {
    const core::RunReport& report = run.report;
    Table table({Align::left, Align::left});
    table.add({"tick", fmt::format("median {}, p99 {}, worst {}", microseconds(report.tick_us.median),
                                   microseconds(report.tick_us.p99), microseconds(report.tick_us.max))});
    if (report.lost_ticks > 0) table.add({"lost", fmt::format("no equilibrium in {} ticks", report.lost_ticks)});
    table.add({"simulated", fmt::format("{} in {} ticks{}", seconds(report.duration), report.ticks,
                                        report.stopped ? ", then stopped before the scene was over" : "")});
    table.add({"recording", run.recording});
    if (run.series) table.add({"series", series_text(*run.series)});
    return table.text(2);
}

}    // namespace

std::string summary_text(const FinishedRun& run) {
    return fmt::format("{}\n  scene {}\n\n{}\n{}\n{}\n{}{}{}", run.report.title, run.scene, events_text(run.report),
                       findings_text(run.report), ledger_text(run.report), hand_text(run.report.hand),
                       real_time_text(run.report.real_time), cost_text(run));
}

bool ended_in_fault(const core::RunReport& report) {
    return std::any_of(report.events.begin(), report.events.end(),
                       [](const core::EventReport& event) { return event.name.starts_with("fault"); });
}

}    // namespace stylet::app
