#include "apps/stylet/study_csv.h"

#include "apps/stylet/csv_cell.h"
#include "apps/stylet/study_words.h"
#include "core/scene/complaints.h"

#include <fmt/format.h>

namespace stylet::app {
namespace {

using study::ErrorOfCases;
using study::Result;
using study::SettingResult;

std::string heading(const Result& result) {
    using core::printable;
    std::string text =
        fmt::format("# stylet study 1\n# title: {}\n# scene: {}\n# measured: {}\n# reference: {}\n", printable(result.title),
                    printable(result.scene), printable(result.measured), printable(result.reference));
    if (!result.judged.empty()) text += fmt::format("# error: {}\n", printable(result.judged));
    if (const std::string timed = timed_text(result); !timed.empty()) text += fmt::format("# timed: {}\n", timed);
    for (const study::FittedOrder& order : result.orders) text += fmt::format("# order: {}\n", printable(order_text(order)));
    return text +
           fmt::format("# machine: {}\n# command: {}\n", printable(machine_text(result.machine)), printable(result.command));
}

std::string names(const Result& result) {
    std::string text = "series,setting,error [1]";
    if (result.split)
        text += fmt::format(",{},{}", csv_cell(result.split->first + " [1]"), csv_cell(result.split->second + " [1]"));
    return text +
           ",error median [1],error p95 [1],error worst [1],median [us],p99 [us],worst [us],waited [1],contended,front,failed,"
           "remarks\n";
}

/// What there is none of has an empty cell.
std::string value(const std::optional<ErrorOfCases>& error) {
    return error ? fmt::format("{}", error->judged) : "";
}

std::string times(const std::optional<study::Timing>& timing) {
    if (!timing) return ",,,,";
    return fmt::format("{},{},{},{},{:d}", timing->median, timing->p99, timing->worst, timing->waited, timing->contended);
}

std::string row(const SettingResult& setting, const Result& result) {
    std::string text = csv_cell(setting.series) + "," + csv_cell(setting.label) + "," + fmt::format("{}", setting.error.judged);
    if (result.split) text += "," + value(setting.split_part) + "," + value(setting.split_rest);
    return text + fmt::format(",{},{},{},{},{:d},{:d},{}\n", setting.error.median, setting.error.p95, setting.error.worst,
                              times(setting.timing), setting.on_front, setting.failed(), csv_cell(remarks_text(setting)));
}

}    // namespace

std::string study_csv(const Result& result) {
    std::string text = heading(result) + names(result);
    for (const SettingResult& setting : result.settings) text += row(setting, result);
    return text;
}

}    // namespace stylet::app
