#include "apps/study/known_answers.h"

#include "apps/study/closed_forms.h"
#include "apps/study/reference_files.h"
#include "core/scene/complaints.h"

#include <fmt/format.h>

#include <algorithm>

namespace stylet::study {
namespace {

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

}    // namespace

KnownAnswers::KnownAnswers(const Study& study, const Plan& plan) : study_(study) {
    if (const auto* file = std::get_if<TableFile>(&study.reference))
        table_ = table_file(file->file, {.unit = unit_of(study.measure)});
    if (const auto* file = std::get_if<CurveFile>(&study.reference))
        curve_ =
            measured_part(curve_file(file->file, std::get<CurveMeasure>(study.measure)), std::get<CurveMeasure>(study.measure));
    if (std::holds_alternative<TableFile>(study.reference)) check_cases(plan);
}

Outcome KnownAnswers::of(const Job& job, std::size_t c, const Outcome& mine) const {
    if (curve_) return *curve_;
    if (const auto* form = std::get_if<ClosedForm>(&study_.reference))
        return closed_form(*form, study_.measure, job.scene, mine.x);
    return {.x = {}, .y = {table_.at(name_of(job, c))}};
}

std::string KnownAnswers::name_of(const Job& job, std::size_t c) const {
    const std::string& name = study_.cases[c].name;
    return name.empty() ? job.scene.file.stem().string() : name;
}

void KnownAnswers::check_cases(const Plan& plan) const {
    std::vector<std::string> missing, there;
    for (const auto& [name, value] : table_) there.push_back(name);
    for (const std::vector<std::size_t>& jobs : plan.mine) {
        for (std::size_t c = 0; c < jobs.size(); ++c) {
            const std::string name = core::quote(name_of(plan.jobs[jobs[c]], c));
            if (!table_.contains(name_of(plan.jobs[jobs[c]], c)) && std::ranges::find(missing, name) == missing.end())
                missing.push_back(name);
        }
    }
    if (missing.empty()) return;
    throw Error(fmt::format("{}: found no value of {}, wanted one for each case; it has {}",
                            std::get<TableFile>(study_.reference).file.string(), core::list_of(missing), core::list_of(there)));
}

}    // namespace stylet::study
