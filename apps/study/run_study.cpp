#include "apps/study/run_study.h"

#include "apps/study/errors.h"
#include "apps/study/known_answers.h"
#include "apps/study/machine.h"
#include "apps/study/measurements.h"
#include "apps/study/orders.h"
#include "apps/study/timing.h"
#include "apps/study/verdict.h"
#include "apps/study/wording.h"

#include <fmt/format.h>

#include <algorithm>

namespace stylet::study {
namespace {

/// Compares what was measured.
class Comparing {
public:
    Comparing(const Study& study, const Plan& plan, const KnownAnswers& known,
              const std::vector<std::optional<Outcome>>& outcomes)
        : study_(study), plan_(plan), known_(known), outcomes_(outcomes) {}

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
        result.is_reference = !plan_.references.empty() && plan_.mine[s] == plan_.references[s];
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
        const std::size_t job = plan_.mine[s][c];
        return known_.of(plan_.jobs[job], c, outcome(job));
    }

    const Study& study_;
    const Plan& plan_;
    const KnownAnswers& known_;
    const std::vector<std::optional<Outcome>>& outcomes_;
};

/// Each series' fitted order, or that there is none.
void add_orders(const Study& study, const std::vector<Setting>& settings, Result& result) {
    for (const Series& series : study.series) {
        std::vector<double> numbers, errors;
        for (std::size_t s = 0; s < result.settings.size(); ++s) {
            if (result.settings[s].series != series.name || result.settings[s].failed() || !settings[s].fitted) continue;
            numbers.push_back(*settings[s].fitted);
            errors.push_back(result.settings[s].error.judged);
        }
        if (const auto order = fitted_order(series.name, study.fit_order, numbers, errors)) {
            result.orders.push_back(*order);
        } else if (!numbers.empty()) {
            result.verdict.push_back(
                fmt::format("{}: no order in {} can be fitted: fewer than three errors fall.", series.name, study.fit_order));
        }
    }
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
    const auto* run = std::get_if<ReferenceRun>(&study.reference);
    result.own_references = run != nullptr && run->of != ReferenceRun::Of::scene;
    if (study.split) result.split = {study.split->name, study.split->rest};
    const Plan plan = plan_of(study, options.folders, result.machine.processor, options.stop);
    result.stopped = options.stop != nullptr && *options.stop;
    if (result.stopped) return result;
    const KnownAnswers known(study, plan);
    const auto outcomes = measure_all(plan, study.timed != Timed::nothing, options);
    const Comparing comparing(study, plan, known, outcomes);
    std::vector<Setting> settings;
    for (std::size_t s = 0; s < plan.settings.size(); ++s) {
        if (comparing.whole(s)) {
            result.settings.push_back(comparing.result(s));
            settings.push_back(plan.settings[s]);
        }
    }
    result.stopped = result.settings.size() < plan.settings.size();
    if (run != nullptr && !result.own_references && !result.settings.empty())
        result.reference_timing = comparing.timing(plan.references.front());
    add_verdict(result);
    if (!study.fit_order.empty()) add_orders(study, settings, result);
    return result;
}

}    // namespace stylet::study
