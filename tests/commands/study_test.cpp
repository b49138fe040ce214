// `stylet study`: what it finds and leaves. What it refuses is study_wrong_test.cpp's.
#include "tests/commands/command.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <boost/process/args.hpp>
#include <boost/process/child.hpp>
#include <boost/process/exe.hpp>
#include <boost/process/io.hpp>
#include <boost/process/start_dir.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <filesystem>
#include <map>
#include <sstream>
#include <thread>

namespace stylet::commands {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

/// Loads of a column in layers by Hermite elements, whose error falls with the fourth power of their number.
constexpr const char* loads = R"(stylet: 1
title: Loads
scene: column.yaml
series:
  - name: winkler
    vary: [{key: needle.buckling.winkler.elements, values: [4, 8, 16], label: "{} elements"}]
measure: {answer: critical_load, depth: 50 mm}
reference: {run: {of: scene, name: converged, set: {needle.buckling.winkler.elements: 128}}}
fit_order: needle.buckling.winkler.elements
time: nothing
)";

/// A bench with two scenes beside whatever study a test writes.
class StudyBench : public Bench {
public:
    StudyBench() {
        fs::copy_file(scene_folder / "studies/base/layered_column.yaml", path("column.yaml"));
        fs::copy_file(scene_folder / "paper/fig10a_l150.yaml", path("gel.yaml"));
    }
};

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

std::vector<std::string> cells_of(const std::string& line) {
    std::vector<std::string> cells{""};
    bool quoted = false;
    for (const char c : line) {
        if (c == '"')
            quoted = !quoted;
        else if (c == ',' && !quoted)
            cells.emplace_back();
        else
            cells.back() += c;
    }
    return cells;
}

/// The rows of a study's CSV, each by the names of its columns.
std::vector<std::map<std::string, std::string>> rows_of(const std::string& csv) {
    std::vector<std::map<std::string, std::string>> rows;
    std::vector<std::string> header;
    for (const std::string& line : lines_of(csv)) {
        if (line.starts_with("#")) continue;
        const std::vector<std::string> cells = cells_of(line);
        if (header.empty()) {
            header = cells;
            continue;
        }
        rows.emplace_back();
        for (std::size_t i = 0; i < std::min(header.size(), cells.size()); ++i) rows.back()[header[i]] = cells[i];
    }
    return rows;
}

std::vector<std::string> column(const std::vector<std::map<std::string, std::string>>& rows, const std::string& name) {
    std::vector<std::string> values;
    for (const auto& row : rows) values.push_back(row.contains(name) ? row.at(name) : "no such column");
    return values;
}

Outcome study(const Bench& bench, const std::string& text, std::vector<std::string> more = {}) {
    bench.write("study.yaml", text);
    more.insert(more.begin(), {"study", "study.yaml"});
    return bench.stylet(more);
}

TEST(Study, FindsTheOrderThatElementsConvergeWith) {
    const StudyBench bench;
    const Outcome outcome = study(bench, loads);
    ASSERT_EQ(outcome.code, 0) << outcome.err;

    const auto rows = rows_of(bench.read("out/study.csv"));
    ASSERT_EQ(rows.size(), 3u) << bench.read("out/study.csv");
    EXPECT_THAT(column(rows, "setting"), ElementsAre("4 elements", "8 elements", "16 elements"));
    constexpr double order = 4.0, slack = 0.15;    // Hermite elements; of the next term, at 4 elements
    for (std::size_t i = 1; i < rows.size(); ++i) {
        const double fell = std::log2(std::stod(rows[i - 1].at("error [1]")) / std::stod(rows[i].at("error [1]")));
        std::printf("error falls with the number of elements to the %.2f\n", fell);
        EXPECT_NEAR(fell, order, slack);
    }
    EXPECT_THAT(outcome.out, HasSubstr("elements^-"));
}

TEST(Study, LeavesAPageWithItsPictureAndATable) {
    const StudyBench bench;
    ASSERT_EQ(study(bench, loads, {"--out", "pages"}).code, 0);
    for (const char* file : {"study.csv", "study.md", "study.png", "study.svg", "study.runs.jsonl"})
        EXPECT_TRUE(bench.has(std::string("pages/") + file)) << file;
    EXPECT_THAT(bench.read("pages/study.md"),
                AllOf(HasSubstr("# Loads"), HasSubstr("(study.png)"), HasSubstr("stylet study study.yaml --out pages"),
                      HasSubstr("16 elements"), Not(HasSubstr(bench.path("").string()))));
}

TEST(Study, GoesOnWhereItWasCutOff) {
    const StudyBench bench;
    ASSERT_EQ(study(bench, loads).code, 0);
    const std::string first = bench.read("out/study.csv"), log = bench.read("out/study.runs.jsonl");
    ASSERT_EQ(lines_of(log).size(), 4u);    // three settings and the reference

    bench.write("out/study.runs.jsonl", log.substr(0, log.size() - 20));    // killed in the middle of a line
    ASSERT_EQ(study(bench, loads).code, 0);
    EXPECT_EQ(bench.read("out/study.csv"), first);
    EXPECT_EQ(lines_of(bench.read("out/study.runs.jsonl")).size(), 5u) << "the cut line, and the one measured again";

    ASSERT_EQ(study(bench, loads).code, 0);
    EXPECT_EQ(lines_of(bench.read("out/study.runs.jsonl")).size(), 5u) << "all is known: nothing was measured";
    ASSERT_EQ(study(bench, loads, {"--again"}).code, 0);
    EXPECT_EQ(lines_of(bench.read("out/study.runs.jsonl")).size(), 4u) << "all is measured anew";
}

TEST(Study, KeepsItsLogWhereTheStudyIsWrong) {
    const StudyBench bench;
    ASSERT_EQ(study(bench, loads).code, 0);
    std::string wrong = loads;
    wrong.replace(wrong.find("elements: 128"), 13, "elements: 999");
    EXPECT_EQ(study(bench, wrong, {"--again"}).code, 2);
    EXPECT_EQ(lines_of(bench.read("out/study.runs.jsonl")).size(), 4u);
}

TEST(Study, LetsASeriesHaveTheLastWord) {
    const StudyBench bench;
    const Outcome outcome = study(bench, R"(stylet: 1
title: Precedence
scene: column.yaml
set: {needle.buckling.winkler.elements: 4}
series:
  - {name: a key, set: {needle.buckling.winkler.elements: 128}}
  - {name: a map, set: {needle.buckling.winkler: {foundation_modulus: disc_between_walls, elements: 128}}}
  - {name: varied, vary: [{key: needle.buckling.winkler.elements, values: [128]}]}
measure: {answer: critical_load, depth: 50 mm}
reference: {run: {of: scene, name: converged, set: {needle.buckling.winkler.elements: 128}}}
time: nothing
)");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    for (const std::string& error : column(rows_of(bench.read("out/study.csv")), "error [1]")) EXPECT_EQ(std::stod(error), 0.0);
}

TEST(Study, IsStoppedByCtrlCAndKeepsWhatItHas) {
    namespace process = boost::process;
    const StudyBench bench;
    bench.write("study.yaml", R"(stylet: 1
title: Long
scene: gel.yaml
series: [{name: short, set: {run.duration: 0.1 s}}, {name: long, set: {run.duration: 100000 s}}]
measure: {value: peak_hand_force}
reference: {run: {of: scene, name: short, set: {run.duration: 0.1 s}}}
time: tick
)");
    process::child run(process::exe = STYLET_EXECUTABLE, process::args({"study", "study.yaml"}),
                       process::start_dir(bench.path("").string()), process::std_out > process::null,
                       process::std_err > bench.path("err").string());
    while (run.running() && (!bench.has("out/study.runs.jsonl") || bench.read("out/study.runs.jsonl").empty()))
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    kill(run.id(), SIGINT);
    run.wait();
    EXPECT_EQ(run.exit_code(), 130);
    EXPECT_THAT(bench.read("err"), HasSubstr("goes on where it was"));
    EXPECT_EQ(lines_of(bench.read("out/study.runs.jsonl")).size(), 1u);
    EXPECT_FALSE(bench.has("out/study.md"));
}

TEST(Study, TimesTicksAndSaysWhatLeavingOutAnEffectChanges) {
    const StudyBench bench;
    const Outcome outcome = study(bench, R"(stylet: 1
title: Effects
scene: gel.yaml
set: {device.motion: [{insert: 70 mm, speed: 70 mm/s}]}
series:
  - {name: all of it}
  - {name: without friction, leave_out: ["effects[1]"]}
  - {name: rigid, set: {needle.type: rigid}}
measure: {curve: hand_force, over: travel}
reference: {run: {of: scene, name: all of it}}
time: tick
repetitions: 2
)");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const auto rows = rows_of(bench.read("out/study.csv"));
    ASSERT_EQ(rows.size(), 3u);
    EXPECT_EQ(std::stod(rows[0].at("error [1]")), 0.0) << "it is the reference";
    // After the puncture 5 N/m of friction hold 50 to 67 mm of shaft: a quarter to a third of a newton, of the 1 N at the
    // puncture, along the last quarter of the way.
    const double friction = std::stod(rows[1].at("error [1]"));
    std::printf("friction changes the force by %.3f of its largest\n", friction);
    EXPECT_GT(friction, 0.05);
    EXPECT_LT(friction, 0.2);
    EXPECT_LT(std::stod(rows[2].at("error [1]")), 0.01) << "a needle that doesn't buckle is as good as rigid";
    for (const std::string& median : column(rows, "median [us]")) EXPECT_GT(std::stod(median), 0.0);
    EXPECT_THAT(outcome.out, AllOf(HasSubstr("Cheapest under 1 %"), HasSubstr("rigid"),
                                   HasSubstr("all of it is the reference itself"), HasSubstr("2 repetitions")));
}

TEST(Study, SaysOfASettingThatItNeverDidWhatIsMeasured) {
    const StudyBench bench;
    std::string text = R"(stylet: 1
title: Puncture
scene: gel.yaml
set: {device.motion: [{insert: 60 mm, speed: 100 mm/s}]}
series: [{name: as it is}, {name: tough, set: {"effects[0].rupture_force": 9 N}}]
measure: {event: punctured, column: hand_force}
reference: {table: known.csv}
time: nothing
)";
    const Outcome outcome = study(bench, text);
    EXPECT_EQ(outcome.code, 2) << "the table is not there yet";
    EXPECT_THAT(outcome.err, AllOf(HasSubstr("study.yaml:7:"), HasSubstr("reference.table"), HasSubstr("'known.csv'")));

    bench.write("known.csv", "case,force [N]\ngel,1\n");
    const Outcome again = bench.stylet({"study", "study.yaml"});
    ASSERT_EQ(again.code, 0) << again.err;
    EXPECT_THAT(again.out, HasSubstr("never punctured"));
    const auto rows = rows_of(bench.read("out/study.csv"));
    constexpr double rounding = 1e-12;
    EXPECT_LT(std::stod(rows[0].at("error [1]")), rounding);
    EXPECT_EQ(rows[1].at("error [1]"), "inf");

    text.replace(text.find("punctured"), 9, "puntcured");
    EXPECT_THAT(study(bench, text).out, HasSubstr("never puntcured; did you mean 'punctured'?"));
}

TEST(Study, DrawsTheSameCasesFromTheSameSeed) {
    const StudyBench bench;
    const std::string drawn = std::string(loads) + R"(cases:
  judge: worst
  random:
    count: 5
    seed: 3
    draw:
      - {key: "tissue.layers[0].youngs_modulus", range: 3..160 kPa, spacing: log}
      - {key: needle.radius, one_of: [0.2 mm, 0.3 mm]}
)";
    ASSERT_EQ(study(bench, drawn).code, 0);
    const std::string first = bench.read("out/study.csv");
    ASSERT_EQ(study(bench, drawn, {"--again"}).code, 0);
    EXPECT_EQ(bench.read("out/study.csv"), first);
    std::string other = drawn;
    other.replace(other.find("seed: 3"), 7, "seed: 4");
    ASSERT_EQ(study(bench, other).code, 0);
    EXPECT_NE(bench.read("out/study.csv"), first);
}

TEST(Study, SplitsAnErrorInTwo) {
    const StudyBench bench;
    const Outcome outcome = study(bench, R"(stylet: 1
title: Split
scene: column.yaml
series: [{name: two terms, set: {needle.buckling.type: layered_explicit, needle.buckling.layered_explicit.terms: 2}}]
split: {name: terms, rest: kind, set: {needle.buckling.layered_explicit.terms: 3}}
measure: {answer: critical_load, depth: 50 mm}
reference: {run: {of: scene, name: converged, set: {needle.buckling.winkler.elements: 128}}}
time: nothing
)");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const auto row = rows_of(bench.read("out/study.csv")).front();
    // Ritz loads lie above the converged one, three terms between two and it: the parts make up the whole.
    const double whole = std::stod(row.at("error [1]")), part = std::stod(row.at("terms [1]")),
                 rest = std::stod(row.at("kind [1]"));
    constexpr double rounding = 1e-9;
    EXPECT_NEAR(1.0 + whole, (1.0 + part) * (1.0 + rest), rounding);
    EXPECT_GT(part, 0.0);
    EXPECT_GT(rest, 0.0);
}

}    // namespace
}    // namespace stylet::commands
