#include "tests/study_pictures/results.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>

namespace stylet::study_pictures {
namespace {

using study::ErrorOfCases;
using study::Result;
using study::SettingResult;
using study::Timed;
using study::Timing;

Result blank(const std::string& title, Timed timed) {
    return {.title = title,
            .question = "How far off is it, and what does it cost?",
            .scene = "paper/fig10a_l200.yaml",
            .measured = "RMS of hand_force over travel, as a share of its largest value",
            .reference = "elliptic integrals (closed form)",
            .judged = "",
            .timed = timed,
            .repetitions = 5,
            .threads = 1,
            .machine = {.processor = "Example 3000",
                        .processors = 2,
                        .system = "Linux 6.1",
                        .build = "stylet 0.1.0, g++ 12.2.0, Release"},
            .command = "stylet study scenes/studies/example.yaml --out out"};
}

ErrorOfCases one_error(double error) {
    return {error, error, error, error};
}

/// A tick like most: its hundredth slowest takes a third longer, one is interrupted.
Timing usual(double median) {
    return {.median = median, .p99 = 1.35 * median, .worst = 4.0 * median + 30.0, .waited = 0.002};
}

void add(Result& result, const std::string& series, const std::string& label, double error, double median) {
    SettingResult& setting = result.settings.emplace_back();
    setting.series = series;
    setting.label = label;
    setting.error = one_error(error);
    setting.timing = usual(median);
}

void fail(SettingResult& setting, const std::string& reason) {
    setting.error = one_error(std::numeric_limits<double>::infinity());
    setting.remarks = {reason};
}

void mark_front(Result& result) {
    for (SettingResult& setting : result.settings) {
        setting.on_front = setting.timing && !setting.failed();
        for (const SettingResult& other : result.settings) {
            const bool beaten = setting.timing && other.timing && !other.failed() && &other != &setting &&
                                other.timing->median <= setting.timing->median && other.error.judged <= setting.error.judged;
            if (beaten) setting.on_front = false;
        }
    }
}

}    // namespace

Result three_settings() {
    Result result = blank("Needles of Fig. 10(a)", Timed::tick);
    add(result, "rigid", "", 0.31, 8.2);
    add(result, "beam_column", "", 0.037, 41.0);
    add(result, "rod", "", 0.0042, 730.0);
    mark_front(result);
    result.verdict = {"The cheapest setting under 5 % is beam_column: 3.7 % at 41.0 µs a tick.",
                      "The cheapest setting under 1 % is rod: 0.42 % at 730 µs a tick.",
                      "The most accurate setting within 1 ms is rod: 0.42 % at 730 µs a tick."};
    return result;
}

Result many_settings() {
    Result result = blank("The whole insertion, Fig. 10(a)", Timed::tick);
    for (const int nodes : {6, 11, 21, 41, 81, 161})
        add(result, "rod", fmt::format("{} nodes", nodes), 1.8 * std::pow(nodes - 1.0, -1.95), 9.0 * std::pow(nodes, 0.95));
    for (const int rate : {250, 500, 1000, 2000, 4000})
        add(result, "beam_column", fmt::format("{} Hz", rate), 0.02 * std::pow(rate / 1000.0, -0.9), 38.0 + 0.0005 * rate);
    for (const int cells : {8, 10, 12, 16, 20, 26, 32})
        add(result, "corotational_fem, newton", fmt::format("{0} × {0} × {1}", cells, cells / 2),
            0.4 * std::pow(cells / 8.0, -2.0), 700.0 * std::pow(cells / 8.0, 3.6));
    for (const int cells : {8, 12, 16, 20, 26, 32})
        add(result, "corotational_fem, quasi_newton", fmt::format("{0} × {0} × {1}", cells, cells / 2),
            0.41 * std::pow(cells / 8.0, -1.9), 60.0 * std::pow(cells / 8.0, 3.1));
    add(result, "half_space", "linear", 0.16, 21.0);
    add(result, "half_space", "patched", 0.155, 23.0);
    result.settings[7].timing->contended = true;
    result.settings[14].timing->contended = true;
    fail(result.settings[6], "never punctured");
    mark_front(result);
    result.orders = {{"rod", "needle.rod.nodes", -1.95, 1e-6, 6}, {"corotational_fem, newton", "tissue.cells", -2.0, 3.1e-4, 7}};
    result.verdict = {"The cheapest setting under 5 % is beam_column, 500 Hz: 3.7 % at 38.3 µs a tick."};
    return result;
}

Result crowd() {
    Result result = blank("Every sensible combination of models", Timed::tick);
    int k = 0;
    for (const char* tissue : {"half_space", "corotational_fem"}) {
        for (const char* needle : {"rigid", "beam_column", "elastica", "rod"}) {
            for (const int rate : {250, 500, 1000, 2000, 4000}) {
                ++k;
                const double scatter = std::sin(12.9898 * k), other = std::sin(78.233 * k);    // no pattern, the same each time
                add(result, fmt::format("{} in {}", needle, tissue), fmt::format("{} Hz", rate),
                    0.02 * std::pow(10.0, 0.9 * scatter), 150.0 * std::pow(10.0, 0.8 * other));
            }
        }
    }
    mark_front(result);
    return result;
}

Result split_errors() {
    Result result = blank("Tissue: solver and mesh", Timed::step);
    result.split = {"solver", "discretisation"};
    result.judged = "median of 20 loads";
    for (const double accuracy : {1e-2, 1e-3, 1e-4}) {
        for (const int cells : {8, 16, 24, 32}) {
            const double solver = 0.4 * accuracy, mesh = 0.12 * std::pow(cells / 8.0, -1.9);
            add(result, fmt::format("quasi_newton to {:g}", accuracy), fmt::format("{} cells", cells), std::hypot(solver, mesh),
                55.0 * std::pow(cells / 8.0, 3.0) * (1.0 - 0.2 * std::log10(accuracy)));
            SettingResult& setting = result.settings.back();
            setting.split_part = one_error(solver);
            setting.split_rest = one_error(mesh);
            setting.error.p95 = 2.1 * setting.error.judged;
            setting.error.worst = 3.4 * setting.error.judged;
        }
    }
    mark_front(result);
    return result;
}

Result odd_settings() {
    Result result = blank("Time step, 0.25 to 4 ms", Timed::tick);
    result.reference = "the same scene at 16000 Hz";
    for (const int rate : {250, 500, 1000, 2000, 4000}) {
        add(result, "rod", fmt::format("{} Hz", rate), 5e-3 * std::pow(rate / 1000.0, -2.0), 180.0 - 0.004 * rate);
        add(result, "beam_column", fmt::format("{} Hz", rate), 2e-2 * std::pow(rate / 1000.0, -1.0), 42.0 - 0.001 * rate);
    }
    add(result, "rigid", "1000 Hz", 0.0, 6.0);
    result.settings[0].error = one_error(4.1e7);
    result.settings[0].remarks = {"found no equilibrium in 3 ticks"};
    fail(result.settings[1], "never punctured");
    result.reference_timing = usual(172.0);
    mark_front(result);
    return result;
}

Result fast_answers() {
    Result result = blank("Critical load of layered columns", Timed::answer);
    result.judged = "median of 200 cases";
    add(result, "printed Eq. (2)", "", 0.31, 0.9);
    add(result, "consistent form", "", 0.024, 1.1);
    add(result, "explicit", "two terms", 0.042, 2.4);
    add(result, "explicit", "three terms", 0.0067, 3.9);
    for (const int elements : {4, 8, 16, 32, 64})
        add(result, "winkler", fmt::format("{} elements", elements), 2.0 * std::pow(elements, -4.0),
            2.6 * std::pow(elements, 1.05));
    for (SettingResult& setting : result.settings) {
        setting.error.p95 = 2.5 * setting.error.judged;
        setting.error.worst = 6.0 * setting.error.judged;
    }
    mark_front(result);
    return result;
}

Result nothing_timed() {
    Result result = fast_answers();
    result.timed = Timed::nothing;
    result.title = "Critical load, errors alone";
    for (SettingResult& setting : result.settings) {
        setting.timing.reset();
        setting.on_front = false;
    }
    add(result, "exact", "", 0.0, 0.0);
    result.settings.back().timing.reset();
    add(result, "euler", "", 0.0, 0.0);
    fail(result.settings.back(), "asks for no tissue");
    result.settings.back().timing.reset();
    return result;
}

}    // namespace stylet::study_pictures
