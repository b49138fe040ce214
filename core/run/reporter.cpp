#include "core/run/reporter.h"

#include <algorithm>
#include <string_view>

namespace stylet::core {

namespace {

constexpr std::size_t warm_up = 100;    // [ticks] whose times are not counted, in a run of more than twice as many

double relative(const Ledger& ledger) {
    return ledger.peak_work() > 0.0 ? ledger.peak_residual() / ledger.peak_work() : 0.0;
}

}    // namespace

Reporter::Reporter(const Scene& scene, const Cast& cast, std::size_t most_ticks)
    : patches_(scene, cast, most_ticks), warm_up_(most_ticks > 2 * warm_up ? warm_up : 0), has_hand_(scene.device.has_value()) {
    report_.title = scene.title;
    report_.hash = scene.hash;
    report_.has_needle = scene.needle.has_value();
    report_.has_tissue = scene.tissue.has_value();
    for (const auto& library : cast.libraries()) report_.libraries.push_back(library.string());
    events_.reserve(most_events);
}

void Reporter::take(const Simulation& simulation, double duration) {
    const Sample& sample = simulation.sample();
    report_.peak_hand_force = std::max(report_.peak_hand_force, sample.hand_force);
    report_.largest_deflection = std::max(report_.largest_deflection, sample.deflection);
    for (const Event& event : simulation.events()) {
        report_.peak_hand_force = std::max(report_.peak_hand_force, event.hand_force);
        if (events_.size() < events_.capacity())
            events_.push_back(event);
        else
            ++report_.unlisted_events;
    }
    patches_.take(simulation);
    if (!simulation.ever_punctured()) report_.ledger.relative_pushing = relative(simulation.ledger());
    if (simulation.lost()) ++report_.lost_ticks;
    if (++ticks_ > warm_up_) durations_.add(duration);
}

RunReport Reporter::finish(const Simulation& simulation) {
    const Sample& last = simulation.sample();
    name_events();
    if (simulation.ever_touched() && !simulation.ever_punctured()) {
        report_.events.push_back({"never punctured", last.time, last.travel, last.depth, last.hand_force});
    }
    report_.ledger.peak_work = simulation.ledger().peak_work();
    report_.ledger.relative = relative(simulation.ledger());
    report_.ledger.totals = last;
    report_.loads = patches_.report();
    if (has_hand_)
        report_.hand = {.force_chain = simulation.force_chain(),
                        .least_port_energy = simulation.passivity().least(),
                        .least_port_energy_without_hold = simulation.passivity().least_without_hold()};
    report_.tick_us = {.median = durations_.quantile(0.5),
                       .p99 = durations_.quantile(0.99),
                       .max = durations_.worst(),
                       .mean = durations_.mean()};
    report_.ticks = ticks_;
    report_.duration = last.time;
    return report_;
}

void Reporter::name_events() {
    for (const Event& event : events_) {
        report_.events.push_back({event.name, event.time, event.travel, event.depth, event.hand_force});
        const std::string_view name = event.name;
        if (name == "buckled" || name == "second buckling") {
            report_.buckling.push_back({.time = event.time, .force = event.hand_force, .critical_load = event.critical_load});
        }
    }
}

}    // namespace stylet::core
