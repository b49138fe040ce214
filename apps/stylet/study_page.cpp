#include "apps/stylet/study_page.h"

#include "apps/stylet/markdown.h"
#include "apps/stylet/study_table.h"
#include "apps/stylet/study_words.h"

#include <fmt/format.h>

namespace stylet::app {
namespace {

using study::Result;

constexpr const char* origin = "<!-- Written by `stylet study`: run it again with the command at the end. -->\n\n";

std::string bullets(const std::vector<std::string>& sentences) {
    std::string text;
    for (const std::string& sentence : sentences) text += "- " + markdown(sentence) + "\n";
    return text.empty() ? "" : text + "\n";
}

std::string table(const Result& result) {
    const StudyTable filled = study_table(result);
    std::string names = "|", rules = "|", rows;
    for (const StudyColumn& column : filled.columns) {
        const std::string comma = column.group.empty() || column.name.empty() ? "" : ", ";
        names += fmt::format(" {} |", markdown(column.name.empty() ? "" : column.group + comma + column.name));
        rules += column.align == Table::Align::right ? "---:|" : "---|";
    }
    for (const std::vector<std::string>& row : filled.rows) {
        rows += "|";
        for (const std::string& cell : row) rows += fmt::format(" {} |", markdown(cell));
        rows += "\n";
    }
    return names + "\n" + rules + "\n" + rows + "\n";
}

std::string orders(const Result& result) {
    if (result.orders.empty()) return "";
    std::string text = "## How the error falls\n\n| series | key | order | points | above |\n|---|---|---:|---:|---:|\n";
    for (const study::FittedOrder& order : result.orders) {
        text += fmt::format("| {} | `{}` | {:.2f} | {} | {} |\n", markdown(order.series), order.key, order.order, order.points,
                            markdown(error_text(order.least_error)));
    }
    return text + "\n";
}

std::string how(const Result& result) {
    std::vector<std::string> facts{"Scene: `" + result.scene + "`", "Error: " + result.measured,
                                   "Reference: " + result.reference};
    if (!result.judged.empty()) facts.push_back("Cases: " + result.judged);
    if (result.timed != study::Timed::nothing)
        facts.push_back(fmt::format("Timed: a {}, {} repetition{} after a warm-up, {} thread{}", word_of(result.timed),
                                    result.repetitions, result.repetitions == 1 ? "" : "s", result.threads,
                                    result.threads == 1 ? "" : "s"));
    facts.push_back("Machine: " + machine_text(result.machine));
    return "## How it was measured\n\n" + bullets(facts);
}

}    // namespace

std::string study_page(const Result& result, const std::string& picture_file) {
    const std::string question = result.question.empty() ? "" : markdown(result.question) + "\n\n";
    const std::string stopped = result.stopped ? "**Stopped before all was run: what is missing is left out.**\n\n" : "";
    return std::string(origin) + "# " + markdown(result.title) + "\n\n" + question + stopped +
           fmt::format("![{}: error over time]({})\n\n", markdown(result.title), picture_file) + bullets(result.verdict) +
           "## Settings\n\n" + table(result) + bullets(marks_explained(result)) + orders(result) + how(result) +
           fmt::format("```sh\n{}\n```\n", result.command);
}

}    // namespace stylet::app
