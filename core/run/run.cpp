#include "core/run/run.h"

#include "core/run/patch_record.h"
#include "core/run/recorder.h"
#include "core/run/simulation.h"

#include <stylet/error.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <thread>

namespace stylet::core {

namespace {

constexpr std::size_t warm_up = 100;           // [ticks] whose times are not counted
constexpr std::size_t progress_every = 256;    // [ticks]

double duration_of(const Scene& scene, const Cast& cast) {
    const double duration = scene.run.duration.value_or(cast.device().duration());
    if (!std::isfinite(duration))
        throw Error("run.duration", "missing, wanted a time: the device's motion has no end of its own");
    return duration;
}

/// The wall time of every tick [µs].
class Stopwatch {
public:
    explicit Stopwatch(std::size_t ticks) { times_.reserve(ticks); }

    template <class Work>
    void time(Work&& work) {
        const auto start = std::chrono::steady_clock::now();
        work();
        times_.push_back(std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - start).count());
    }

    TickReport report() {
        const auto first = times_.begin() + static_cast<std::ptrdiff_t>(times_.size() > 2 * warm_up ? warm_up : 0);
        if (first == times_.end()) return {};
        std::sort(first, times_.end());
        const auto at = [&](double fraction) {
            return *(first + static_cast<std::ptrdiff_t>(fraction * static_cast<double>(times_.end() - first - 1)));
        };
        return {.median = at(0.5), .p99 = at(0.99), .max = at(1.0)};
    }

private:
    std::vector<double> times_;
};

/// Collects what a report says from tick to tick.
class Reporter {
public:
    Reporter(const Scene& scene, const Cast& cast, std::size_t ticks) : patches_(scene, cast, ticks) {
        report_.title = scene.title;
        report_.hash = scene.hash;
        report_.has_needle = scene.needle.has_value();
        report_.has_tissue = scene.tissue.has_value();
        has_hand_ = scene.device.has_value();
        for (const auto& library : cast.libraries()) report_.libraries.push_back(library.string());
    }

    void take(const Simulation& simulation) {
        const Sample& sample = simulation.sample();
        report_.peak_hand_force = std::max(report_.peak_hand_force, sample.hand_force);
        report_.largest_deflection = std::max(report_.largest_deflection, sample.deflection);
        for (const Event& event : simulation.events()) note(event);
        patches_.take(simulation);
        if (!simulation.ever_punctured()) report_.ledger.relative_pushing = relative(simulation.ledger());
    }

    RunReport finish(const Simulation& simulation, Stopwatch& watch, std::size_t ticks) {
        const Sample& last = simulation.sample();
        if (simulation.ever_touched() && !simulation.ever_punctured()) {
            report_.events.push_back({"never punctured", last.time, last.travel, last.depth, last.hand_force});
        }
        report_.ledger.peak_work = simulation.ledger().peak_work();
        report_.ledger.relative = relative(simulation.ledger());
        report_.ledger.totals = last;
        report_.loads = patches_.report();
        if (has_hand_)
            report_.hand = {.force_chain = simulation.force_chain(), .least_port_energy = simulation.least_port_energy()};
        report_.tick_us = watch.report();
        report_.ticks = ticks;
        report_.duration = last.time;
        return report_;
    }

private:
    static double relative(const Ledger& ledger) {
        return ledger.peak_work() > 0.0 ? ledger.peak_residual() / ledger.peak_work() : 0.0;
    }

    void note(const Event& event) {
        report_.events.push_back({event.name, event.time, event.travel, event.depth, event.hand_force});
        report_.peak_hand_force = std::max(report_.peak_hand_force, event.hand_force);
        const std::string_view name = event.name;
        if (name == "buckled" || name == "second buckling") {
            report_.buckling.push_back({.time = event.time, .force = event.hand_force, .critical_load = event.critical_load});
        }
    }

    RunReport report_;
    PatchRecord patches_;
    bool has_hand_ = false;
};

}    // namespace

RunReport run(const Scene& scene, const PluginFolders& folders, const RunOptions& options) {
    const Cast cast(scene, folders);
    const auto ticks = static_cast<std::size_t>(std::llround(duration_of(scene, cast) * scene.run.rate));
    Simulation simulation(scene, cast);
    Reporter reporter(scene, cast, ticks);
    Stopwatch watch(ticks);
    std::optional<Recorder> recorder;
    if (options.recording) {
        recorder.emplace(*options.recording, Recorder::Heading{scene.title, scene.file.filename().string(), scene.hash},
                         columns_of(scene.record));
    }
    if (options.observe) options.observe(simulation);
    for (std::size_t i = 0; i < ticks; ++i) {
        watch.time([&] { simulation.tick(); });
        reporter.take(simulation);
        while (recorder && !recorder->push(simulation.sample(), simulation.events()))
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        if (options.observe) options.observe(simulation);
        if (options.progress && i % progress_every == 0) options.progress(static_cast<double>(i) / static_cast<double>(ticks));
    }
    if (recorder) recorder->finish();
    if (options.progress) options.progress(1.0);
    return reporter.finish(simulation, watch, ticks);
}

}    // namespace stylet::core
