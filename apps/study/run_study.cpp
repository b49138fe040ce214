#include "apps/study/run_study.h"

#include "apps/study/closed_forms.h"
#include "apps/study/errors.h"
#include "apps/study/machine.h"
#include "apps/study/orders.h"
#include "apps/study/plan.h"
#include "apps/study/reference_files.h"
#include "apps/study/run_log.h"
#include "apps/study/stopwatch.h"
#include "apps/study/timing.h"
#include "apps/study/verdict.h"
#include "apps/study/wording.h"
#include "core/workers/worker_pool.h"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <map>
#include <mutex>
#include <thread>

namespace stylet::study {
namespace {

constexpr std::atomic<bool> never{false};

/// Measures a plan's jobs, those that the log does not know yet.
class Measurements {
public:
    Measurements(const Plan& plan, const Options& options)
        : plan_(plan),
          options_(options),
          stop_(options.stop == nullptr ? never : *options.stop),
          log_(options.log),
          outcomes_(plan.jobs.size()) {
        for (std::size_t i = 0; i < plan.jobs.size(); ++i) {
            if (const Outcome* known = log_.find(plan.jobs[i].key)) {
                outcomes_[i] = *known;
            } else {
                left_.push_back(i);
            }
        }
    }

    /// What each job left; nothing where it was stopped.
    std::vector<std::optional<Outcome>> take(bool timed) {
        const std::size_t threads = timed ? 1 : std::min(left_.size(), static_cast<std::size_t>(core::processors()));
        std::vector<std::thread> others;
        for (std::size_t i = 1; i < threads; ++i) others.emplace_back([this] { work(); });
        work();
        for (std::thread& other : others) other.join();
        if (failed_) std::rethrow_exception(failed_);
        return std::move(outcomes_);
    }

private:
    void work() {
        try {
            for (std::size_t next = next_++; next < left_.size() && !stop_ && !given_up_; next = next_++) {
                const Job& job = plan_.jobs[left_[next]];
                const auto progress = [&](double share) { tell(job.name, share); };
                progress(0.0);
                const auto outcome = measure(job, options_.folders, stop_, progress);
                if (!outcome) return;
                log_.add(job.key, job.name, *outcome);
                outcomes_[left_[next]] = *outcome;
                ++done_;
            }
        } catch (...) {
            const std::lock_guard lock(mutex_);
            failed_ = std::current_exception();
            given_up_ = true;
        }
    }

    void tell(const std::string& name, double share) {
        if (!options_.progress) return;
        const auto done = static_cast<double>(done_) + share, all = static_cast<double>(left_.size());
        const std::lock_guard lock(mutex_);
        Progress progress{
            .done = static_cast<std::size_t>(done_), .all = left_.size(), .share = done / all, .seconds_left = {}, .name = name};
        if (done > 0.0) progress.seconds_left = watch_.wall() * (all - done) / done;
        options_.progress(progress);
    }

    const Plan& plan_;
    const Options& options_;
    const std::atomic<bool>& stop_;
    RunLog log_;
    std::vector<std::optional<Outcome>> outcomes_;
    std::vector<std::size_t> left_;    // still to be measured
    std::atomic<std::size_t> next_{0}, done_{0};
    std::atomic<bool> given_up_{false};
    std::exception_ptr failed_;
    std::mutex mutex_;
    Stopwatch watch_;
};

/// The samples of a curve from elsewhere that lie on the measured stretch.
Outcome measured_part(const Outcome& curve, const CurveMeasure& measure) {
    Outcome part;
    for (std::size_t i = 0; i < curve.x.size(); ++i) {
        if (!measure.holds(curve.x[i])) continue;
        part.x.push_back(curve.x[i]);
        part.y.push_back(curve.y[i]);
    }
    return part;
}

/// Compares what was measured.
class Comparing {
public:
    Comparing(const Study& study, const Plan& plan, const std::vector<std::optional<Outcome>>& outcomes)
        : study_(study), plan_(plan), outcomes_(outcomes) {
        if (const auto* file = std::get_if<TableFile>(&study.reference))
            table_ = table_file(file->file, {.unit = unit_of(study.measure)});
        if (const auto* file = std::get_if<CurveFile>(&study.reference))
            curve_ = measured_part(curve_file(file->file, std::get<CurveMeasure>(study.measure)),
                                   std::get<CurveMeasure>(study.measure));
    }

    [[nodiscard]] bool whole(std::size_t setting) const {
        const auto there = [&](const std::vector<std::vector<std::size_t>>& jobs) {
            return jobs.empty() ||
                   std::ranges::all_of(jobs[setting], [&](std::size_t job) { return outcomes_[job].has_value(); });
        };
        return there(plan_.mine) && there(plan_.references) && there(plan_.twins);
    }

    [[nodiscard]] SettingResult result(std::size_t s) const {
        const Setting& setting = plan_.settings[s];
        SettingResult result{.series = setting.series, .label = setting.label, .error = {}};
        const auto mine = [&](std::size_t c) { return outcome(plan_.mine[s][c]); };
        const auto twin = [&](std::size_t c) { return outcome(plan_.twins[s][c]); };
        const auto known = [&](std::size_t c) { return reference(s, c); };
        result.error = errors(mine, known, &result.remarks);
        if (study_.split) {
            result.split_part = errors(mine, twin, nullptr);
            result.split_rest = errors(twin, known, nullptr);
        }
        result.failed = !std::isfinite(result.error.judged);
        for (std::size_t c = 0; c < study_.cases.size(); ++c) {
            for (const std::string& remark : mine(c).remarks) add_remark(remark, result.remarks);
        }
        result.timing = timing(plan_.mine[s]);
        return result;
    }

    [[nodiscard]] std::optional<Timing> timing(const std::vector<std::size_t>& jobs) const {
        std::vector<Timing> timings;
        for (const std::size_t job : jobs) {
            if (outcome(job).timing) timings.push_back(*outcome(job).timing);
        }
        return timings.empty() ? std::nullopt : std::optional(of_cases(timings));
    }

private:
    [[nodiscard]] const Outcome& outcome(std::size_t job) const { return *outcomes_[job]; }

    static void add_remark(const std::string& remark, std::vector<std::string>& remarks) {
        if (std::ranges::find(remarks, remark) == remarks.end()) remarks.push_back(remark);
    }

    /// Over the cases; why there is none in some of them goes to the remarks.
    template <class Mine, class Known>
    [[nodiscard]] ErrorOfCases errors(Mine&& mine, Known&& known, std::vector<std::string>* remarks) const {
        std::vector<double> errors;
        for (std::size_t c = 0; c < study_.cases.size(); ++c) {
            const ErrorOfOutcome error = error_of(mine(c), known(c));
            errors.push_back(error.error);
            if (remarks != nullptr && !error.why.empty()) add_remark(error.why, *remarks);
        }
        return errors_of_cases(std::move(errors), study_.judge);
    }

    [[nodiscard]] Outcome reference(std::size_t s, std::size_t c) const {
        if (std::holds_alternative<ReferenceRun>(study_.reference)) return outcome(plan_.references[s][c]);
        if (curve_) return *curve_;
        const std::size_t job = plan_.mine[s][c];
        if (const auto* form = std::get_if<ClosedForm>(&study_.reference))
            return closed_form(*form, study_.measure, plan_.jobs[job].scene, outcome(job).x);
        const std::string name = study_.cases[c].name.empty() ? plan_.jobs[job].scene.file.stem().string() : study_.cases[c].name;
        const auto found = table_.find(name);
        if (found == table_.end()) return {.x = {}, .y = {}, .missing = fmt::format("no known value of {}", name)};
        return {.x = {}, .y = {found->second}};
    }

    const Study& study_;
    const Plan& plan_;
    const std::vector<std::optional<Outcome>>& outcomes_;
    std::map<std::string, double> table_;
    std::optional<Outcome> curve_;
};

/// Each series' fitted order, where there are points enough.
std::vector<FittedOrder> orders_of(const Study& study, const std::vector<Setting>& settings, const Result& result) {
    std::vector<FittedOrder> orders;
    for (const Series& series : study.series) {
        std::vector<double> numbers, errors;
        for (std::size_t s = 0; s < result.settings.size(); ++s) {
            if (result.settings[s].series != series.name || result.settings[s].failed || !settings[s].fitted) continue;
            numbers.push_back(*settings[s].fitted);
            errors.push_back(result.settings[s].error.judged);
        }
        if (const auto order = fitted_order(series.name, study.fit_order, numbers, errors)) orders.push_back(*order);
    }
    return orders;
}

}    // namespace

Result run_study(const Study& study, const Options& options) {
    Result result{.title = study.title,
                  .question = study.question,
                  .scene = scenes_words(study),
                  .measured = measure_words(study.measure),
                  .reference = reference_words(study),
                  .judged = judge_words(study),
                  .timed = study.timed,
                  .repetitions = study.repetitions,
                  .threads = study.threads,
                  .machine = this_machine(),
                  .command = ""};
    if (study.split) result.split = {study.split->name, study.split->rest};
    const Plan plan = plan_of(study, options.folders, result.machine.processor);
    const auto outcomes = Measurements(plan, options).take(study.timed != Timed::nothing);
    const Comparing comparing(study, plan, outcomes);
    std::vector<Setting> settings;
    for (std::size_t s = 0; s < plan.settings.size(); ++s) {
        if (comparing.whole(s)) {
            result.settings.push_back(comparing.result(s));
            settings.push_back(plan.settings[s]);
        }
    }
    result.stopped = result.settings.size() < plan.settings.size();
    const auto* run = std::get_if<ReferenceRun>(&study.reference);
    if (run != nullptr && run->of == ReferenceRun::Of::scene && !result.settings.empty())
        result.reference_timing = comparing.timing(plan.references.front());
    if (!study.fit_order.empty()) result.orders = orders_of(study, settings, result);
    add_verdict(result);
    return result;
}

}    // namespace stylet::study
