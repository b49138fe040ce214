#include "apps/stylet/study_table.h"

#include "apps/stylet/study_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace stylet::app {
namespace {

using study::ErrorOfCases;
using study::Result;
using study::SettingResult;
using Align = Table::Align;

/// A column and what stands in it.
struct Filled {
    StudyColumn column;
    std::function<std::string(const SettingResult&)> cell;
};

bool any(const Result& result, const std::function<bool(const SettingResult&)>& has) {
    return std::ranges::any_of(result.settings, has);
}

std::string judged_part(const std::optional<ErrorOfCases>& part) {
    return part ? error_text(part->judged) : "";
}

void add_errors(const Result& result, std::vector<Filled>& columns) {
    columns.push_back({{"", "error", Align::right}, [](const SettingResult& s) { return error_text(s.error.judged); }});
    if (result.split) {
        columns.push_back(
            {{"of it", result.split->first, Align::right}, [](const SettingResult& s) { return judged_part(s.split_part); }});
        columns.push_back(
            {{"of it", result.split->second, Align::right}, [](const SettingResult& s) { return judged_part(s.split_rest); }});
    }
    if (result.judged.empty()) return;
    // The one that is the error itself needs no second column.
    const auto add = [&](const char* name, double ErrorOfCases::*value) {
        if (!any(result, [value](const SettingResult& s) { return s.error.*value != s.error.judged; })) return;
        columns.push_back(
            {{"cases", name, Align::right}, [value](const SettingResult& s) { return error_text(s.error.*value); }});
    };
    add("median", &ErrorOfCases::median);
    add("p95", &ErrorOfCases::p95);
    add("worst", &ErrorOfCases::worst);
}

/// How many times shorter than the reference.
std::string speed_up(const SettingResult& setting, const study::Timing& reference) {
    if (!setting.timing || !(setting.timing->median > 0.0)) return "";
    const double ratio = reference.median / setting.timing->median;
    return fmt::format("{:.{}f} ×", ratio, ratio < 10.0 ? 1 : 0);
}

/// The mark stands before the number, so that numbers stay below one another.
std::string marked_median(const SettingResult& setting) {
    if (!setting.timing) return "";
    return (setting.timing->contended ? std::string(contended_mark) + " " : "") + time_text(setting.timing->median);
}

void add_times(const Result& result, std::vector<Filled>& columns) {
    if (!any(result, [](const SettingResult& s) { return s.timing.has_value(); })) return;
    const std::string timed = each(result.timed);
    const auto add = [&](const char* name, double study::Timing::*value) {
        columns.push_back({{timed, name, Align::right},
                           [value](const SettingResult& s) { return s.timing ? time_text((*s.timing).*value) : ""; }});
    };
    columns.push_back({{timed, "median", Align::right}, marked_median});
    add("p99", &study::Timing::p99);
    add("worst", &study::Timing::worst);
    if (result.reference_timing)
        columns.push_back(
            {{"", "speed-up", Align::right}, [&](const SettingResult& s) { return speed_up(s, *result.reference_timing); }});
}

std::vector<Filled> columns_of(const Result& result) {
    std::vector<Filled> columns{{{"", "series", Align::left}, [](const SettingResult& s) { return s.series; }}};
    if (any(result, [](const SettingResult& s) { return !s.label.empty(); }))
        columns.push_back({{"", "setting", Align::left}, [](const SettingResult& s) { return s.label; }});
    add_errors(result, columns);
    add_times(result, columns);
    if (any(result, [](const SettingResult& s) { return s.on_front; }))
        columns.push_back({{"", "front", Align::left}, [](const SettingResult& s) { return s.on_front ? front_mark : ""; }});
    if (any(result, [](const SettingResult& s) { return !s.remarks.empty(); }))
        columns.push_back({{"", "remarks", Align::left}, [](const SettingResult& s) { return remarks_text(s); }});
    return columns;
}

}    // namespace

StudyTable study_table(const Result& result) {
    StudyTable table;
    const std::vector<Filled> columns = columns_of(result);
    for (const Filled& column : columns) table.columns.push_back(column.column);
    for (const SettingResult& setting : result.settings) {
        std::vector<std::string>& row = table.rows.emplace_back();
        for (const Filled& column : columns) row.push_back(column.cell(setting));
    }
    return table;
}

std::vector<std::string> marks_explained(const Result& result) {
    std::vector<std::string> sentences;
    if (any(result, [](const SettingResult& s) { return s.on_front; })) {
        const char* const where = result.own_references
                                      ? "on its series' Pareto front: no other setting of it is both cheaper and nearer"
                                      : "on the Pareto front: no other setting is both cheaper and nearer";
        sentences.push_back(fmt::format("{} {}.", front_mark, where));
    }
    if (any(result, [](const SettingResult& s) { return s.timing && s.timing->contended; }))
        sentences.push_back(fmt::format("{} contended: the machine had other work, however often this was run.", contended_mark));
    return sentences;
}

}    // namespace stylet::app
