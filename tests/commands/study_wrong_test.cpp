// What `stylet study` refuses, in its words.
#include "tests/commands/command.h"

#include <gtest/gtest.h>

#include <filesystem>

namespace stylet::commands {
namespace {

/// What is wrong with a study beside scenes/studies/base/layered_column.yaml as column.yaml.
std::string told_of(const std::string& study) {
    const Bench bench;
    std::filesystem::copy_file(scene_folder / "studies/base/layered_column.yaml", bench.path("column.yaml"));
    bench.write("study.yaml", study);
    const Outcome outcome = bench.stylet({"study", "study.yaml"});
    EXPECT_EQ(outcome.code, 2) << outcome.out;
    EXPECT_EQ(outcome.out, "");
    EXPECT_FALSE(bench.has("out/study.csv"));
    return outcome.err;
}

TEST(WrongStudy, IsNotThere) {
    const Outcome outcome = Bench().stylet({"study", "nowhere.yaml"});
    EXPECT_EQ(outcome.code, 2);
    EXPECT_EQ(outcome.err, "nowhere.yaml: found no such file, wanted a study\n");
}

TEST(WrongStudy, IsEmpty) {
    EXPECT_EQ(told_of(""), "study.yaml:1:1: found an empty file, wanted a study that begins with 'stylet: 1'\n");
}

TEST(WrongStudy, IsAScene) {
    const Bench bench;
    EXPECT_EQ(bench.stylet({"study", paper("fig9")}).err,
              paper("fig9") + ": found a scene, wanted a study; stylet run plays it\n");
    const std::string study = (scene_folder / "studies/time_step.yaml").string();
    EXPECT_EQ(bench.stylet({"run", study}).err, study + ": found a study, wanted a scene; stylet study runs it\n");
    EXPECT_EQ(bench.stylet({"scenes"}).out.find("studies/time_step.yaml"), std::string::npos);
}

TEST(WrongStudy, HasEveryErrorToldAtOnce) {
    EXPECT_EQ(told_of(R"(stylet: 1
titel: A study
scene: colum.yaml
series:
  - name: winkler
    vary:
      - {key: needle.radius, range: 5..1 mm, points: 3, spacing: log}
      - {key: needle.length, values: [1 mm], range: 1..2 mm}
  - {name: winkler, set: [needle.radius]}
cases: {judge: best, list: []}
measure: {curve: hand_forse, over: travel, depth: 1}
reference: {closed_form: elastika}
time: ticks
)"),
              R"(study.yaml:1:1: title: found nothing, wanted text (one line for the page)
study.yaml:2:1: titel: found an unknown key, wanted one of title, question, scene, fit_order, time, repetitions, threads, stylet, set, leave_out, vary, series, cases, measure, reference, split; did you mean 'title'?
study.yaml:3:8: scene: found 'colum.yaml', which is not there, wanted the name of a file inside the scene's folder tree (the scene that is varied; left out, each series names its own)
study.yaml:7:37: series[0].vary[0].range: found '5..1 mm', wanted the smaller end first
study.yaml:8:9: series[0].vary[1]: found both of values and range, wanted one
study.yaml:9:5: series[1].name: found 'winkler' a second time, wanted each once
study.yaml:9:26: series[1].set: found a list, wanted a map (keys of the scene and what they become)
study.yaml:10:16: cases.judge: found 'best', wanted one of rms, median, p95, worst (which of the cases' errors stands for all)
study.yaml:10:28: cases.list: found an empty list, wanted a list of maps
study.yaml:11:18: measure.curve: found 'hand_forse', wanted one of time, travel, depth, inserted, hand_force, device_force, tip_force, friction_force, critical_load, deflection, free_length, contacts, patch_displacement, energy_force, energy_force_printed, port_energy, hand_work, load_work, stored, kinetic, fracture, friction, burst, released, damping, numerical, residual; did you mean 'hand_force'?
study.yaml:11:51: measure.depth: found '1' without a unit, wanted a length in m such as '25 mm' (how much of the needle is inserted; wanted with `answer`)
study.yaml:11:51: measure.depth: found it beside 'curve', wanted it with 'answer' alone
study.yaml:12:26: reference.closed_form: found the closed form 'elastika', wanted one of: elastica, euler, flat_punch, love; did you mean 'elastica'?
study.yaml:13:7: time: found 'ticks', wanted one of nothing, tick, step, load, answer (what is timed: a tick of the run; a step, the tick of a scene with a single body; a load, from the scene to its first tick; an answer of the buckling model); did you mean 'tick'?
)");
}

TEST(WrongStudy, ChangesAKeyThatTheSceneHasNot) {
    EXPECT_EQ(told_of(R"(stylet: 1
title: A study
scene: column.yaml
series:
  - name: winkler
    vary: [{key: needle.bukling.type, values: [winkler]}]
  - name: other
    set: {needle.buckling.winkler.elements: 3}
  - name: third
    leave_out: ["effects[1]"]
measure: {answer: critical_load, depth: 80 mm}
reference: {run: {of: scene, name: itself}}
time: answer
)"),
              R"(study.yaml: itself: found a depth of 0.08 m, wanted at most 0.05 m: so much of the needle can be inside
study.yaml:6:12: needle.bukling.type: found no key 'needle.bukling' in the scene; did you mean 'buckling'?
study.yaml:8:11: needle.buckling.winkler.elements: found '3', wanted at least 4 and at most 128 (of the column; left out: 64)
study.yaml:10:17: effects[1]: found no key 'effects' in the scene
)");
}

TEST(WrongStudy, TimesWhatItDoesNotMeasure) {
    EXPECT_EQ(told_of(R"(stylet: 1
title: A study
scene: column.yaml
series: [{name: winkler}]
measure: {answer: critical_load, depth: 50 mm}
reference: {run: {of: scene, name: itself}}
fit_order: needle.length
time: tick
)"),
              R"(study.yaml:7:12: fit_order: found 'needle.length', which no series varies
study.yaml:8:7: time: found a measure that is an answer, wanted 'answer' or 'nothing': no scene is run
)");
}

}    // namespace
}    // namespace stylet::commands
