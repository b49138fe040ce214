#include "core/run/run.h"

#include "core/run/player.h"
#include "core/run/real_time_loop.h"
#include "core/workers/worker_pool.h"

#include <stylet/error.h>

#include <chrono>
#include <cmath>
#include <thread>

namespace stylet::core {

namespace {

constexpr std::size_t progress_every = 256;    // [ticks]
constexpr std::atomic<bool> never{false};

std::size_t ticks_of(const Scene& scene, const Cast& cast) {
    const double duration = scene.run.duration.value_or(cast.device().duration());
    if (!std::isfinite(duration))
        throw Error("run.duration", "missing, wanted a time: the device's motion has no end of its own");
    return static_cast<std::size_t>(std::llround(duration * scene.run.rate));
}

double share(std::size_t done, std::size_t ticks) {
    return static_cast<double>(done) / static_cast<double>(ticks);
}

}    // namespace

RunReport run(const Scene& scene, const PluginFolders& folders, const RunOptions& options) {
    WorkerPool workers(options.threads);
    const Cast cast(scene, folders, workers);
    const std::size_t ticks = ticks_of(scene, cast);
    const std::atomic<bool>& stop = options.stop == nullptr ? never : *options.stop;
    Player player(scene, cast, ticks, options.recording);
    if (options.observe) options.observe(player.simulation());
    for (std::size_t i = 0; i < ticks && !stop; ++i) {
        player.tick(scene.run.dt());
        while (!player.note()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
        if (options.observe) options.observe(player.simulation());
        if (options.progress && i % progress_every == 0) options.progress(share(i, ticks));
    }
    while (player.let_go()) {
    }
    if (options.progress) options.progress(1.0);
    RunReport report = player.finish();
    report.stopped = report.ticks < ticks;
    return report;
}

RunReport run_in_real_time(const Scene& scene, const PluginFolders& folders, const RunOptions& options) {
    WorkerPool workers(options.threads, RealTimeLoop::priority);
    const Cast cast(scene, folders, workers);
    const std::size_t ticks = ticks_of(scene, cast);
    Player player(scene, cast, ticks, options.recording);
    RealTimeLoop loop(scene.run.dt());
    const RealTimeReport real_time = loop.run(
        ticks, {[&](double held) { player.tick(held); }, [&] { return player.note(); }, [&] { return player.let_go(); }},
        [&](std::size_t done) {
            if (options.progress) options.progress(share(done, ticks));
        },
        options.stop == nullptr ? never : *options.stop);
    RunReport report = player.finish();
    report.real_time = real_time;
    report.stopped = report.ticks < ticks;
    return report;
}

}    // namespace stylet::core
