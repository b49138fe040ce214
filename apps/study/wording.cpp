#include "apps/study/wording.h"

#include "apps/study/closed_forms.h"
#include "core/run/sample.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <system_error>

namespace stylet::study {
namespace {

/// As seen from the study: a page says nothing of where on a machine they lie.
std::string seen_from(const Study& study, const std::filesystem::path& file) {
    if (study.file.empty()) return file.filename().string();
    std::error_code failed;    // then it is told as it was given
    const std::filesystem::path folder = std::filesystem::weakly_canonical(study.file, failed).parent_path();
    return std::filesystem::weakly_canonical(file, failed).lexically_proximate(folder).string();
}

std::string shown(double value, const std::string& unit) {
    constexpr double mm = 1e-3;    // [m]
    return unit == "m" ? fmt::format("{:g} mm", value / mm) : fmt::format("{:g} {}", value, unit);
}

/// " from 2 mm to 80 mm"
std::string stretch(const CurveMeasure& measure) {
    const core::Column* over = core::column_named(measure.over);
    std::string words;
    if (std::isfinite(measure.from)) words += " from " + shown(measure.from, over->unit);
    if (std::isfinite(measure.to)) words += " to " + shown(measure.to, over->unit);
    return words;
}

struct MeasureWords {
    std::string operator()(const CurveMeasure& m) const {
        return fmt::format("RMS difference of {} over {}{}, as a share of the reference's largest {}", m.column, m.over,
                           stretch(m), m.column);
    }
    std::string operator()(const ValueMeasure& m) const {
        const bool whole_run = m.value.starts_with("peak_") || m.value.starts_with("largest_");
        return fmt::format("relative error of {}{}", m.value, whole_run ? "" : " in the end");
    }
    std::string operator()(const EventMeasure& m) const {
        return fmt::format("relative error of {} when it is first {}", m.column, m.event);
    }
    std::string operator()(const AnswerMeasure& m) const {
        return fmt::format("relative error of the critical load with {} inserted", shown(m.depth, "m"));
    }
};

const char* judge_word(Judge judge) {
    switch (judge) {
        case Judge::rms:
            return "RMS";
        case Judge::median:
            return "median";
        case Judge::p95:
            return "95th percentile";
        case Judge::worst:
            break;
    }
    return "worst";
}

}    // namespace

std::string scenes_words(const Study& study) {
    std::vector<std::string> names;
    const auto add = [&](const std::filesystem::path& file) {
        const std::string name = seen_from(study, file);
        if (std::ranges::find(names, name) == names.end()) names.push_back(name);
    };
    for (const Case& one : study.cases) {
        for (const Series& series : study.series) add(one.scene.value_or(series.scene));
    }
    return fmt::format("{}", fmt::join(names, ", "));
}

std::string measure_words(const Measure& measure) {
    return std::visit(MeasureWords{}, measure);
}

std::string reference_words(const Study& study) {
    if (const auto* form = std::get_if<ClosedForm>(&study.reference)) return closed_form_title(*form);
    if (const auto* file = std::get_if<CurveFile>(&study.reference))
        return fmt::format("the curve in {}", seen_from(study, file->file));
    if (const auto* file = std::get_if<TableFile>(&study.reference))
        return fmt::format("the table {}", seen_from(study, file->file));
    const ReferenceRun& run = std::get<ReferenceRun>(study.reference);
    switch (run.of) {
        case ReferenceRun::Of::scene:
            return run.name;
        case ReferenceRun::Of::series:
            return fmt::format("{}, each series by itself", run.name);
        case ReferenceRun::Of::setting:
            break;
    }
    return fmt::format("{}, each setting by itself", run.name);
}

std::string judge_words(const Study& study) {
    if (study.cases.size() < 2) return "";
    return fmt::format("{} of {} cases", judge_word(study.judge), study.cases.size());
}

}    // namespace stylet::study
