// The keys of a study, declared as a scene's are.
#pragma once

#include <stylet/parameters.h>

namespace stylet::study {

inline constexpr Parameter study_keys[] = {
    text("title", "one line for the page"),
    optional(text("question", "what a reader asks, a paragraph for the page")),
    optional(file("scene", "the scene that is varied; left out, each series names its own")),
    optional(text("fit_order", "a varied key: the order in which each series' error falls with it is fitted")),
    choice(
        "time", "nothing tick step load answer",
        "what is timed: a tick of the run; a step, the tick of a scene with a single body; a load, from the scene to its first "
        "tick; an answer of the buckling model"),
    optional(integer("repetitions", {.least = 1, .greatest = 100}, "of what is timed; left out: one")),
    optional(integer("threads", {.least = 1, .greatest = 256}, "that models may share their work among; left out: one")),
};

inline constexpr Parameter series_keys[] = {
    text("name", "what table and picture call the series"),
    optional(file("scene", "the series' own scene; left out, the study's")),
};

inline constexpr Parameter cases_keys[] = {
    choice("judge", "rms median p95 worst", "which of the cases' errors stands for all"),
};

inline constexpr Parameter case_keys[] = {
    text("name", "what errors and tables of known values call the case"),
    optional(file("scene", "the case's own scene; left out, the series'")),
};

inline constexpr Parameter random_keys[] = {
    integer("count", {.least = 1, .greatest = 10000}, "how many cases are drawn"),
    integer("seed", {.least = 0}, "of the random numbers: the same seed, the same cases"),
};

inline constexpr Parameter measure_keys[] = {
    optional(text("curve", "a recorded column whose RMS difference from the reference is measured")),
    optional(text("over", "the recorded column along which it is; wanted with `curve`")),
    optional(text("from", "where on it the measure begins; left out: where the run does")),
    optional(text("to", "where it ends; left out: where the run does")),
    optional(text("value", "peak_hand_force, largest_deflection, or a recorded column's last value")),
    optional(text("event", "an event, such as punctured, at which a column is measured")),
    optional(text("column", "the recorded column at the event; wanted with `event`")),
    optional(choice("answer", "critical_load", "what the scene's buckling model answers")),
    optional(number("depth", "m", not_negative, "how much of the needle is inserted; wanted with `answer`")),
};

inline constexpr Parameter reference_keys[] = {
    optional(text("closed_form", "a formula that knows the answer, by its name")),
    optional(file("curve", "a CSV with the measure's two columns, as recordings have them")),
    optional(file("table", "a CSV `case,value [unit]` of known values")),
};

inline constexpr Parameter run_keys[] = {
    text("name", "what the page calls the reference"),
    choice("of", "scene series setting", "what the reference's changes are made to: the scene, each series, or each setting"),
};

inline constexpr Parameter split_keys[] = {
    text("name", "of the error against the setting with these changes"),
    text("rest", "of that setting's own error"),
};

}    // namespace stylet::study
