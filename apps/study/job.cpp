#include "apps/study/job.h"

#include "apps/study/inserted_column.h"
#include "apps/study/run_observer.h"
#include "apps/study/stopwatch.h"
#include "apps/study/timing.h"
#include "core/loading/loaded.h"
#include "core/run/durations.h"
#include "core/run/run.h"
#include "core/scene/scene_files.h"
#include "core/scene/sha1.h"
#include "core/workers/worker_pool.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <limits>
#include <map>

namespace stylet::study {
namespace {

/// The bytes of a library, as a hash; each file is read once.
std::string library_hash(const std::filesystem::path& file) {
    static std::map<std::filesystem::path, std::string> known;
    const auto [place, is_new] = known.emplace(file, "");
    if (is_new) {
        core::Sha1 sha;
        sha.add(core::read_bytes(file, std::numeric_limits<std::size_t>::max()));
        place->second = sha.hexadecimal();
    }
    return place->second;
}

std::vector<std::string> types_of(const core::Scene& scene) {
    std::vector<std::string> types;
    for (const auto* choice : {&scene.tissue, &scene.needle, &scene.buckling, &scene.device}) {
        if (*choice) types.push_back((*choice)->type);
    }
    for (const core::Choice& effect : scene.effects) types.push_back(effect.type);
    return types;
}

struct MeasureText {
    std::string operator()(const CurveMeasure& m) const {
        return fmt::format("curve {} {} {} {}", m.column, m.over, m.from, m.to);
    }
    std::string operator()(const ValueMeasure& m) const { return fmt::format("value {}", m.value); }
    std::string operator()(const EventMeasure& m) const { return fmt::format("event {} {}", m.event, m.column); }
    std::string operator()(const AnswerMeasure& m) const { return fmt::format("answer {}", m.depth); }
};

/// One thing that is measured, as often as the job wants it and the machine makes it needful.
class Measuring {
public:
    Measuring(const Job& job, const core::PluginFolders& folders, const std::atomic<bool>& stop,
              const std::function<void(double)>& progress)
        : job_(job), folders_(folders), stop_(stop), progress_(progress) {}

    std::optional<Outcome> measure() {
        try {
            const bool answer = std::holds_alternative<AnswerMeasure>(job_.measure);
            repeat([&](bool first) { return answer ? ask(first) : run(first); });
        } catch (const core::SceneErrors& errors) {
            outcome_.missing = fmt::format("refused: {}", errors.messages().front());
        } catch (const Error& error) {
            outcome_.missing = fmt::format("refused: {}: {}", error.key(), error.what());
        }
        if (stop_) return std::nullopt;
        return std::move(outcome_);
    }

private:
    /// Once more for each that had to wait for the machine, but no more than twice as often as wanted.
    template <class Once>
    void repeat(Once&& once) {
        const bool timed = job_.timed != Timed::nothing;
        const int wanted = timed ? job_.repetitions : 1;
        std::vector<Timing> timings;
        int good = 0;
        for (int i = 0; good < wanted && i < 2 * wanted && !stop_; ++i) {
            done_ = std::min(static_cast<double>(i) / wanted, 1.0 - 1.0 / wanted);
            share_ = 1.0 / wanted;
            timings.push_back(once(i == 0));
            good += timings.back().waited <= most_waited ? 1 : 0;
            if (!outcome_.missing.empty()) break;
        }
        if (timed && !timings.empty()) outcome_.timing = of_repetitions(timings, wanted);
    }

    Timing run(bool first) {
        RunObserver observer(job_.measure);
        Stopwatch watch;
        double load = 0.0, loading_waited = 0.0;    // [s], and a share of it
        bool begun = false;
        core::RunOptions options;
        options.threads = job_.threads;
        options.stop = &stop_;
        options.progress = [this](double share) { progress_(done_ + share_ * share); };
        options.observe = [&](const core::Simulation& simulation) {
            if (!begun) {
                load = watch.wall();
                loading_waited = watch.waited();
                watch.start();
                begun = true;
            } else if (first) {
                observer.take(simulation);
            }
        };
        const core::RunReport report = core::run(job_.scene, folders_, options);
        const double waited = watch.waited();
        if (first) outcome_ = observer.finish(report);
        if (job_.timed == Timed::load) {
            constexpr double us = 1e6;    // in a second
            return {.median = load * us, .p99 = load * us, .worst = load * us, .mean = load * us, .waited = loading_waited};
        }
        return {.median = report.tick_us.median,
                .p99 = report.tick_us.p99,
                .worst = report.tick_us.max,
                .mean = report.tick_us.mean,
                .waited = waited};
    }

    /// The model's answer, and how long it takes. Every question is a little another one: a model that remembers its last answer
    /// shall not be timed for remembering.
    Timing ask(bool first) {
        core::Loaded<BucklingModel> model(job_.scene, *job_.scene.buckling, folders_);
        const double inserted = std::min(std::get<AnswerMeasure>(job_.measure).depth, deepest(job_.scene));
        const Column column = inserted_column(job_.scene, inserted);
        const double load = model.ask([&](const BucklingModel& asked) { return asked.critical_load(column); });
        if (first) outcome_.y = {load};
        if (job_.timed == Timed::nothing) return {};
        Stopwatch watch;
        const Batches batches = model.ask([&](const BucklingModel& asked) { return batches_of(asked, column); });
        const auto of_one = [&](double us) { return us / batches.answers; };
        return {.median = of_one(batches.durations.quantile(0.5)),
                .p99 = of_one(batches.durations.quantile(0.99)),
                .worst = of_one(batches.durations.worst()),
                .mean = of_one(batches.durations.mean()),
                .waited = watch.waited()};
    }

    /// Times of batches of answers, each long enough for the clock: of a batch's answers the mean is known.
    struct Batches {
        core::Durations durations;    // [µs] of each
        int answers = 1;              // in each
    };

    static Batches batches_of(const BucklingModel& model, Column column) {
        constexpr int batches = 300, warm_up = 5;
        constexpr double least = 20.0;    // [µs] of a batch: two hundred times what reading the clock takes
        constexpr double other = 1e-9;    // of the stiffness, from one question to the next
        using Clock = std::chrono::steady_clock;
        Batches taken;
        volatile double kept = 0.0;    // the answers are wanted
        for (int i = 0; i < warm_up + batches; ++i) {
            const auto start = Clock::now();
            for (int k = 0; k < taken.answers; ++k) {
                column.bending_stiffness *= 1.0 + other;
                kept = model.critical_load(column);
            }
            const double us = std::chrono::duration<double, std::micro>(Clock::now() - start).count();
            if (i >= warm_up) {
                taken.durations.add(us);
            } else if (us < least && taken.answers < 1 << 20) {
                taken.answers *= 2;
                i = 0;
            }
        }
        (void)kept;
        return taken;
    }

    const Job& job_;
    const core::PluginFolders& folders_;
    const std::atomic<bool>& stop_;
    const std::function<void(double)>& progress_;
    Outcome outcome_;
    double done_ = 0.0, share_ = 1.0;    // of the job, by earlier repetitions and by this one
};

}    // namespace

std::string key_of(const Job& job, const core::PluginFolders& folders, const std::string& processor) {
    core::Sha1 sha;
    sha.add(job.scene.hash);
    sha.add(std::visit(MeasureText{}, job.measure));
    sha.add(fmt::format("{} {} {}", static_cast<int>(job.timed), job.repetitions, job.threads));
    if (job.timed != Timed::nothing) sha.add(fmt::format("{} {}", processor, core::processors()));
    for (const std::string& type : types_of(job.scene)) {
        if (const auto file = folders.find(type)) sha.add(library_hash(*file));
    }
    sha.add(library_hash("/proc/self/exe"));
    return sha.hexadecimal();
}

std::optional<Outcome> measure(const Job& job, const core::PluginFolders& folders, const std::atomic<bool>& stop,
                               const std::function<void(double)>& progress) {
    return Measuring(job, folders, stop, progress).measure();
}

}    // namespace stylet::study
