// What a study asks: which settings of a scene are run, what they are measured by, and what is timed.
#pragma once

#include "core/scene/reader.h"

#include <cstdint>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace stylet::study {

/// A key of the scene and what it becomes, one after the other.
struct Vary {
    std::string key;
    std::vector<std::string> values;    // each as YAML
    std::string label;                  // of a point, {} standing for the value
    std::string given;                  // where the study says so, as errors name it
};

/// Settings that belong together: one colour of the picture.
struct Series {
    std::string name;
    std::filesystem::path scene;
    std::vector<core::Override> changes;
    std::vector<Vary> vary{};    // every combination of them is a setting; none: the series is one setting
};

/// One of the situations in which every setting is tried.
struct Case {
    std::string name;
    std::optional<std::filesystem::path> scene{};    // in place of the series' own
    std::vector<core::Override> changes{};
};

/// Which of the cases' errors stands for all of them.
enum class Judge : std::uint8_t { rms, median, p95, worst };

/// RMS of a recorded column's difference over another one, as a share of the reference's largest value.
struct CurveMeasure {
    std::string column, over;
    double from = -std::numeric_limits<double>::infinity(), to = std::numeric_limits<double>::infinity();    // of `over` [SI]

    [[nodiscard]] bool holds(double x) const { return from <= x && x <= to; }
};
/// What a run's summary says in the end: peak_hand_force, largest_deflection, or a column's last value.
struct ValueMeasure {
    std::string value;
};
/// A column when an event happens first.
struct EventMeasure {
    std::string event, column;
};
/// What the scene's buckling model answers, with so much of the needle inserted.
struct AnswerMeasure {
    double depth;    // [m]
};
using Measure = std::variant<CurveMeasure, ValueMeasure, EventMeasure, AnswerMeasure>;

/// A formula that knows the answer.
struct ClosedForm {
    std::string name;
};
/// A curve from a file: a CSV with the measure's two columns.
struct CurveFile {
    std::filesystem::path file;
};
/// Known values from a file: a CSV `case,value [unit]`.
struct TableFile {
    std::filesystem::path file;
};
/// A run of its own: with these changes on top of the study's scene, of each series, or of each setting.
struct ReferenceRun {
    enum class Of : std::uint8_t { scene, series, setting };
    Of of;
    std::string name;
    std::vector<core::Override> changes;
};
using Reference = std::variant<ClosedForm, CurveFile, TableFile, ReferenceRun>;

/// Splits an error in two: that of a setting against its twin (`changes` on top of it), and that of the twin against the
/// reference.
struct Split {
    std::string name;    // of the first part: solver
    std::string rest;    // of the second: discretisation
    std::vector<core::Override> changes;
};

enum class Timed : std::uint8_t { nothing, tick, step, load, answer };

struct Study {
    std::filesystem::path file;
    std::string title;
    std::string question;    // a paragraph for the page; may be empty
    std::filesystem::path scene;
    std::vector<core::Override> changes;    // on every run, the reference's too
    std::vector<Series> series;             // their changes come after the study's
    std::vector<Case> cases;                // at least one; a study without cases has one without a name
    Judge judge = Judge::worst;
    Measure measure;
    Reference reference;
    std::optional<Split> split;
    std::string fit_order{};    // a varied key: of the error in it, for each series; empty: none
    Timed timed = Timed::tick;
    int repetitions = 1;
    int threads = 1;
};

}    // namespace stylet::study
