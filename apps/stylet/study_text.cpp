#include "apps/stylet/study_text.h"

#include "apps/stylet/study_table.h"
#include "apps/stylet/study_words.h"

#include <algorithm>
#include <utility>

namespace stylet::app {
namespace {

using study::Result;

constexpr std::size_t indent = 2, page_width = 120;    // [characters]

/// A group's name stands over its first column.
std::vector<std::string> group_row(const StudyTable& filled) {
    std::vector<std::string> row;
    std::string last;
    for (const StudyColumn& column : filled.columns)
        row.push_back(column.group == std::exchange(last, column.group) ? "" : column.group);
    return row;
}

std::string settings_text(const Result& result) {
    const StudyTable filled = study_table(result);
    std::vector<Table::Align> aligned;
    std::vector<std::string> names;
    for (const StudyColumn& column : filled.columns) {
        aligned.push_back(column.align);
        names.push_back(column.name);
    }
    Table table(aligned);
    if (const std::vector<std::string> groups = group_row(filled);
        std::ranges::any_of(groups, [](const std::string& group) { return !group.empty(); }))
        table.add(groups);
    table.add(names);
    for (const std::vector<std::string>& row : filled.rows) table.add(row);
    return table.text(indent);
}

std::string lines(const std::vector<std::string>& sentences) {
    std::string text;
    for (const std::string& sentence : sentences) text += wrapped(sentence, indent, page_width);
    return text.empty() ? "" : text + "\n";
}

std::string orders_text(const Result& result) {
    std::vector<std::string> orders;
    for (const study::FittedOrder& order : result.orders) orders.push_back(order_text(order));
    return lines(orders);
}

std::string timing_text(const Result& result) {
    Table facts({Table::Align::left, Table::Align::left});
    facts.add({"measured", result.measured});
    facts.add({"reference", result.reference});
    if (!result.judged.empty()) facts.add({"error", result.judged});
    facts.add({"machine", machine_text(result.machine)});
    if (const std::string timed = timed_text(result); !timed.empty()) facts.add({"timed", timed});
    return facts.text(indent) + "\n";
}

}    // namespace

std::string study_text(const Result& result) {
    const std::string stopped = result.stopped ? "  Stopped before all was run: what is missing is left out.\n" : "";
    std::string verdict = lines(result.verdict);
    if (!verdict.empty()) verdict.pop_back();
    return result.title + "\n" + stopped + settings_text(result) + "\n" + lines(marks_explained(result)) + orders_text(result) +
           timing_text(result) + verdict;
}

}    // namespace stylet::app
