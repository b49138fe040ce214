#include "apps/stylet/study_page.h"

#include "apps/study/timing.h"
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
        names += fmt::format(" {} |", markdown_cell(column.group + (column.group.empty() ? "" : ", ") + column.name));
        rules += column.align == Table::Align::right ? "---:|" : "---|";
    }
    for (const std::vector<std::string>& row : filled.rows) {
        rows += "|";
        for (const std::string& cell : row) rows += fmt::format(" {} |", markdown_cell(cell));
        rows += "\n";
    }
    return names + "\n" + rules + "\n" + rows + "\n";
}

std::string orders(const Result& result) {
    if (result.orders.empty()) return "";
    std::string text =
        "## How the error falls\n\n"
        "By least squares of logarithms, error ~ key^order, of the points above the error named.\n\n"
        "| series | key | order | points | above |\n|---|---|---:|---:|---:|\n";
    for (const study::FittedOrder& order : result.orders) {
        text += fmt::format("| {} | {} | {:.2f} | {} | {} |\n", markdown_cell(order.series), markdown_cell('`' + order.key + '`'),
                            order.order, order.points, markdown_cell(error_text(order.least_error)));
    }
    return text + "\n";
}

/// What a time in the table is.
std::string timing_words(const Result& result) {
    const char* const warm_up = result.timed == study::Timed::load ? ""
                                : result.timed == study::Timed::answer
                                    ? ", after a warm-up; of a batch of answers that takes 20 µs the mean is one"
                                    : ", without the first 100 of a run of more than 200";
    return fmt::format(
        "Timed: {}{}. Of each repetition the median, p99 and worst are taken; the table has the medians of the first two, and "
        "the worst of all. A repetition that the machine kept waiting for more than {:g} % of its time is made again; what stays "
        "so is marked {}.",
        timed_text(result), warm_up, 100.0 * study::most_waited, contended_mark);
}

std::string how(const Result& result) {
    std::vector<std::string> facts{"Scene: `" + result.scene + "`", "Error: " + result.measured,
                                   "Reference: " + result.reference};
    if (!result.judged.empty()) facts.push_back("Cases: the error is the " + result.judged);
    if (result.timed != study::Timed::nothing) facts.push_back(timing_words(result));
    if (result.reference_timing)
        facts.push_back(fmt::format("The reference itself takes {} {}; the speed-up is over that.",
                                    time_text(result.reference_timing->median), each(result.timed)));
    facts.push_back("Machine: " + machine_text(result.machine));
    return "## How it was measured\n\n" + bullets(facts) + "This page again:\n\n";
}

/// A link's goal, which must not end at a blank or a bracket.
std::string link_to(const std::string& file) {
    return file.find_first_of(" ()") == std::string::npos ? file : "<" + file + ">";
}

}    // namespace

std::string study_page(const Result& result, const std::string& picture_file) {
    const std::string question = result.question.empty() ? "" : markdown(result.question) + "\n\n";
    const std::string stopped = result.stopped ? "**Stopped before all was run: what is missing is left out.**\n\n" : "";
    return std::string(origin) + "# " + markdown(result.title) + "\n\n" + question + stopped +
           fmt::format("![{}: {}]({})\n\n", markdown(result.title),
                       result.timed == study::Timed::nothing ? "the error of each setting" : "error over time",
                       link_to(picture_file)) +
           bullets(result.verdict) + "## Settings\n\n" + table(result) + bullets(marks_explained(result)) + orders(result) +
           how(result) + fmt::format("```sh\n{}\n```\n", result.command);
}

}    // namespace stylet::app
