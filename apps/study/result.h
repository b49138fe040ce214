// What a study found.
#pragma once

#include "apps/study/study.h"

#include <cmath>

namespace stylet::study {

/// Of what was timed, over all its repetitions and cases.
struct Timing {
    double median = 0.0, p99 = 0.0, worst = 0.0;    // [µs]
    double mean = 0.0;                              // [µs] of a tick; of what else is timed, 0
    double waited = 0.0;       // share of the wall time in which the machine did not run us, of the repetitions that count
    bool contended = false;    // it was too much of it, however often the run was repeated
};

/// A setting's error against the reference, relative; infinite where it did not do what is measured (it never punctured).
struct ErrorOfCases {
    double judged = 0.0;                            // the study's judge of these
    double median = 0.0, p95 = 0.0, worst = 0.0;    // over the cases; all the same where there is one
};

struct SettingResult {
    std::string series;    // "rod"
    std::string label;     // "41 nodes"; empty where the series is one setting
    ErrorOfCases error;
    std::optional<Timing> timing{};                            // of what was timed
    std::optional<ErrorOfCases> split_part{}, split_rest{};    // where the study splits the error
    std::vector<std::string> remarks{};                        // "never punctured", "found no equilibrium in 3 ticks"
    bool on_front = false;                                     // no other setting is both cheaper and nearer
    bool is_reference = false;                                 // in each case the very run it is compared with

    /// It did not do what is measured.
    [[nodiscard]] bool failed() const { return !std::isfinite(error.judged); }
    /// "rod, 41 nodes"
    [[nodiscard]] std::string name() const { return label.empty() ? series : series + ", " + label; }
};

/// How an error falls with a varied number: error ~ number^order, by least squares of logarithms.
struct FittedOrder {
    std::string series;
    std::string key;
    double order;
    double least_error;    // below it the points say nothing (what is left is not the key's) and are left out
    int points;            // that were fitted
};

/// Where and with what the times were taken.
struct Machine {
    std::string processor;
    int processors;
    std::string system;
    std::string build;    // "stylet 0.1.0, g++ 12.2.0, Release"
};

struct Result {
    std::string title;
    std::string question;
    std::string scene;              // files' names, as the study gives them
    std::string measured;           // "RMS of hand_force over travel, as a share of its largest value"
    std::string reference;          // "elliptic integrals (closed form)"
    bool own_references = false;    // each series has its own: errors of different series are of different things
    std::string judged;             // "median of 200 cases"; empty where there is one
    Timed timed;
    int repetitions, threads;
    std::optional<std::pair<std::string, std::string>> split{};    // the parts' names
    std::vector<SettingResult> settings{};
    std::optional<Timing> reference_timing{};    // where the reference is one timed run
    std::vector<FittedOrder> orders{};
    std::vector<std::string> verdict{};    // sentences to end with
    Machine machine;
    std::string command;     // that makes it again
    bool stopped = false;    // before all was run: what is missing is left out
};

}    // namespace stylet::study
