#include "apps/study/plan.h"

#include "apps/study/changes.h"
#include "apps/study/closed_forms.h"
#include "apps/study/gathered_errors.h"
#include "apps/study/inserted_column.h"
#include "core/run/sample.h"
#include "core/scene/complaints.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

namespace stylet::study {
namespace {

/// The recorded columns that a measure takes.
std::vector<std::string> columns_of(const Measure& measure) {
    if (const auto* curve = std::get_if<CurveMeasure>(&measure)) return {curve->column, curve->over};
    if (const auto* value = std::get_if<ValueMeasure>(&measure)) return {value->value};
    if (const auto* event = std::get_if<EventMeasure>(&measure)) return {event->column};
    return {};
}

class Planning {
public:
    Planning(const Study& study, const core::PluginFolders& folders, const std::string& processor, const std::atomic<bool>* stop)
        : study_(study), folders_(folders), processor_(processor), stop_(stop) {}

    Plan plan() {
        plan_.settings = settings_of(study_);
        check_size();
        check_names();
        const auto* run = std::get_if<ReferenceRun>(&study_.reference);
        std::vector<std::size_t> of_all;
        if (run != nullptr && run->of == ReferenceRun::Of::scene)
            of_all = jobs_of(study_.scene, joined(study_.changes, run->changes), run->name);
        for (const Setting& setting : plan_.settings) {
            plan_.mine.push_back(jobs_of(setting.scene, setting.changes, setting.name()));
            if (run != nullptr)
                plan_.references.push_back(run->of == ReferenceRun::Of::scene ? of_all : reference_of(*run, setting));
            if (study_.split) {
                const std::string name = fmt::format("{} ({} apart)", setting.name(), study_.split->name);
                plan_.twins.push_back(jobs_of(setting.scene, joined(setting.changes, study_.split->changes), name));
            }
        }
        errors_.throw_if_any();
        return std::move(plan_);
    }

private:
    /// A slip of the pen must not fill the machine.
    void check_size() const {
        constexpr std::size_t most = 20000;
        const std::size_t size = plan_.settings.size() * study_.cases.size();
        if (size <= most) return;
        throw core::SceneErrors({fmt::format("{}: found {} settings in {} cases, wanted at most {} runs", study_.file.string(),
                                             plan_.settings.size(), study_.cases.size(), most)});
    }

    /// Every setting is told by its name.
    void check_names() const {
        std::set<std::string> names;
        for (const Setting& setting : plan_.settings) {
            if (names.insert(setting.name()).second) continue;
            throw core::SceneErrors({fmt::format("{}: found two settings called {}, wanted labels that tell them apart",
                                                 study_.file.string(), core::quote(setting.name()))});
        }
    }

    std::vector<std::size_t> reference_of(const ReferenceRun& run, const Setting& setting) {
        const bool series = run.of == ReferenceRun::Of::series;
        return jobs_of(setting.scene, joined(series ? setting.of_series : setting.changes, run.changes),
                       fmt::format("{}, {}", series ? setting.series : setting.name(), run.name));
    }

    std::vector<std::size_t> jobs_of(const std::filesystem::path& scene, const std::vector<core::Override>& changes,
                                     const std::string& name) {
        std::vector<std::size_t> jobs;
        for (const Case& one : study_.cases) {
            if (stop_ != nullptr && *stop_) break;
            const std::string named = one.name.empty() ? name : fmt::format("{}, {}", name, one.name);
            errors_.gather([&] { jobs.push_back(job_of(one.scene.value_or(scene), joined(changes, one.changes), named)); });
        }
        return jobs;
    }

    std::size_t job_of(const std::filesystem::path& file, const std::vector<core::Override>& changes, const std::string& name) {
        Job job{.scene = core::read_scene(file, changes, folders_),
                .name = name,
                .key = "",
                .measure = study_.measure,
                .timed = study_.timed,
                .repetitions = study_.repetitions,
                .threads = study_.threads};
        check(job);
        job.key = key_of(job, folders_, processor_);
        const auto [place, is_new] = by_key_.emplace(job.key, plan_.jobs.size());
        if (is_new) plan_.jobs.push_back(std::move(job));
        return place->second;
    }

    [[noreturn]] void refuse(const Job& job, const std::string& sentence) const {
        const std::string told_by = study_.file.empty() ? job.scene.file.string() : study_.file.string();
        throw core::SceneErrors({fmt::format("{}: {}: {}", told_by, job.name, sentence)});
    }

    /// Whether the scene has what is measured and timed.
    void check(const Job& job) const {
        const core::Scene& scene = job.scene;
        const bool needle = scene.needle.has_value(), tissue = scene.tissue.has_value();
        for (const std::string& name : columns_of(job.measure)) {
            const core::Column* column = core::column_named(name);
            const bool missing = column == nullptr ? !needle : !core::there(*column, needle, tissue);
            if (missing) refuse(job, fmt::format("found no {} in {}, wanted a scene that has it", name, scene.file.string()));
        }
        if (job.timed == Timed::step && needle && tissue)
            refuse(job, "found needle and tissue where a body's 'step' is timed, wanted one of them, or 'time: tick'");
        if (const auto* answer = std::get_if<AnswerMeasure>(&job.measure)) check_answer(job, *answer);
        if (const auto* form = std::get_if<ClosedForm>(&study_.reference)) {
            try {
                (void)closed_form(*form, job.measure, scene, {});
            } catch (const Error& error) {
                refuse(job, error.what());
            }
        }
    }

    void check_answer(const Job& job, const AnswerMeasure& answer) const {
        if (!job.scene.needle || !job.scene.buckling)
            refuse(job, fmt::format("found no buckling model in {}, wanted one that answers", job.scene.file.string()));
        constexpr double rounding = 1e-9;    // of a length: sums and units written in decimals
        const double most = deepest(job.scene);
        if (answer.depth > most * (1.0 + rounding))
            refuse(job, fmt::format("found a depth of {:g} m, wanted at most {:g} m: so much of the needle can be inside",
                                    answer.depth, most));
    }

    const Study& study_;
    const core::PluginFolders& folders_;
    const std::string& processor_;
    const std::atomic<bool>* stop_;
    Plan plan_{};
    GatheredErrors errors_;
    std::map<std::string, std::size_t> by_key_;
};

}    // namespace

Plan plan_of(const Study& study, const core::PluginFolders& folders, const std::string& processor,
             const std::atomic<bool>* stop) {
    return Planning(study, folders, processor, stop).plan();
}

}    // namespace stylet::study
