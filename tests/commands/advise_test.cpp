// `stylet advise`: which setting to take, and what effects cost and change. Runs are short here; times are never asked after.
#include "tests/commands/command.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <boost/process/args.hpp>
#include <boost/process/child.hpp>
#include <boost/process/exe.hpp>
#include <boost/process/io.hpp>
#include <boost/process/start_dir.hpp>

#include <nlohmann/json.hpp>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <thread>

namespace stylet::commands {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

const std::string column = (scene_folder / "validation" / "column_in_air_pinned.yaml").string();
const std::string block = (scene_folder / "validation" / "block_m0.yaml").string();

/// An hour is a budget that every tick keeps, on any machine.
const std::vector<std::string> any_time{"--budget", "1 hour"};

Outcome advised(const Bench& bench, const std::string& scene, std::vector<std::string> more) {
    std::vector<std::string> arguments{"advise", scene, "--threads", "1"};
    arguments.insert(arguments.end(), any_time.begin(), any_time.end());
    arguments.insert(arguments.end(), more.begin(), more.end());
    return bench.stylet(arguments);
}

/// The one of this name, or null.
json named(const json& list, const char* key, const std::string& name) {
    for (const json& one : list) {
        if (one[key] == name) return one;
    }
    return nullptr;
}

/// 5 mm at 100 mm/s into tissue of a coarse mesh, at 500 Hz.
const std::vector<std::string> short_insertion{"--set", "device.motion=[{insert: 5 mm, speed: 100 mm/s}]",
                                               "--set", "tissue.corotational_fem.cells=[4, 4, 2]",
                                               "--set", "run.rate=500 Hz",
                                               "--set", "needle.rod.nodes=11"};

TEST(Advise, TellsWhatItMeasuredAgainstWhatAndWhatToTake) {
    const Bench bench;
    const Outcome advice = advised(bench, column, {"--set", "run.duration=0.05 s", "--error", "50%"});
    ASSERT_EQ(advice.code, 0) << advice.err;
    EXPECT_THAT(advice.err, IsEmpty());
    EXPECT_THAT(advice.out, StartsWith("A column in air pushed against a pin\n"));
    EXPECT_THAT(advice.out, HasSubstr("RMS of hand_force over time"));
    EXPECT_THAT(advice.out, ContainsRegex("reference +rod with needle.rod.nodes=81 \\("));
    EXPECT_THAT(advice.out, ContainsRegex("beam_column, euler \\(the scene\\) +[0-9.]+ % "));
    EXPECT_THAT(advice.out, ContainsRegex("    run.rate=500 Hz .*not to be taken: the rate is the hand's"));
    EXPECT_THAT(
        advice.out,
        ContainsRegex(
            "  Take [a-z_, ]+: [0-9.e-]+ % off, .* a tick, (99 of 100 ticks within|by the median: the machine was busy)"));
    EXPECT_THAT(advice.out, ContainsRegex("\n  effects\\[0\\] pin +[^ ].* % +.* N\n"));
}

TEST(Advise, WeighsEveryCombinationOfModelsOfAWholeScene) {
    const Bench bench;
    std::vector<std::string> arguments = short_insertion;
    arguments.insert(arguments.end(), {"--error", "90%", "--json", "advice.json"});
    const Outcome run = advised(bench, paper("fig10a_l150"), arguments);
    ASSERT_EQ(run.code, 0) << run.err;
    const json advice = json::parse(bench.read("advice.json"));
    for (const char* tissue : {"half_space", "corotational_fem"}) {
        for (const char* needle : {"beam_column, euler", "elastica, euler", "rod", "rigid"}) {
            const json setting = named(advice["settings"], "name", std::string(tissue) + ", " + needle);
            ASSERT_FALSE(setting.is_null()) << tissue << ", " << needle;
            EXPECT_TRUE(setting["error"].is_number()) << setting;
            EXPECT_TRUE(setting["tick"]["p99_us"].is_number());
            EXPECT_TRUE(setting["within_budget"]);
        }
    }
    EXPECT_EQ(advice["left_out"].size(), 1u) << advice["left_out"];
    EXPECT_EQ(advice["left_out"][0]["name"], "winkler");
    constexpr double idle_error = 0.09;    // a tenth of the error asked for: nothing nearer by less is taken instead
    const json taken = named(advice["settings"], "name", advice["take"].get<std::string>());
    for (const json& setting : advice["settings"]) {
        if (setting["set"].contains("run.rate")) continue;
        EXPECT_GE(setting["error"].get<double>(), taken["error"].get<double>() - idle_error) << setting["name"];
    }
}

/// The advised command, on the bench's own `stylet`.
std::string advised_command(const std::string& text) {
    const std::string name = "stylet run ";
    const std::size_t begin = text.find("\n      " + name);
    if (begin == std::string::npos) return "";
    const std::size_t words = text.find(name, begin) + name.size();
    return STYLET_EXECUTABLE " run " + text.substr(words, text.find('\n', words) - words);
}

/// How a run ends that the shell starts in the bench's folder, and its summary.
std::string run_by_shell(const Bench& bench, const std::string& command) {
    const std::string line = "cd '" + bench.path("").string() + "' && " + command + " > ran.txt 2>&1";
    return std::system(line.c_str()) == 0 ? "" : bench.read("ran.txt");
}

TEST(Advise, PrintsACommandThatAShellTakesAndThatKeepsTheUsersOwnChanges) {
    const Bench bench;
    const Outcome run = advised(bench, column,
                                {"--set", "run.duration=0.02 s", "--set", "title=It's a \"short\" one", "--set",
                                 "needle.beam_column={}", "--error", "99%", "--reference", "needle.type=rod"});
    ASSERT_EQ(run.code, 0) << run.err;
    EXPECT_THAT(run.out, ContainsRegex("scene +.*column_in_air_pinned.yaml --set 'run.duration=0.02 s'"));
    const std::string command = advised_command(run.out);
    EXPECT_THAT(command, HasSubstr(" --set 'run.duration=0.02 s' --set 'title=It'\\''s a \"short\" one' --set"));
    EXPECT_EQ(run_by_shell(bench, command + " --out out"), "") << command;
    EXPECT_THAT(bench.read("ran.txt"), StartsWith("It's a \"short\" one\n"));
}

TEST(Advise, TellsAScriptWhatTheUserChanged) {
    const Outcome run =
        advised(Bench(), column, {"--set", "run.duration=0.02 s", "--reference", "needle.type=rod", "--json", "-"});
    ASSERT_EQ(run.code, 0) << run.err;
    EXPECT_EQ(json::parse(run.out)["set"], json({{"run.duration", "0.02 s"}}));
}

TEST(Advise, TakesTheScenesPeriodForTheBudget) {
    const Outcome run = Bench().stylet({"advise", column, "--set", "run.duration=0.02 s", "--set", "run.rate=500 Hz",
                                        "--reference", "needle.type=rod", "--json", "-"});
    ASSERT_EQ(run.code, 0) << run.err;
    EXPECT_DOUBLE_EQ(json::parse(run.out)["budget_s"].get<double>(), 0.002);
}

TEST(Advise, SaysWhatEachEffectChanges) {
    const Bench bench;
    const Outcome run = advised(bench, block, {"--set", "run.duration=0.02 s", "--reference", "run.rate=1 kHz", "--json", "-"});
    ASSERT_EQ(run.code, 0) << run.err;
    const json advice = json::parse(run.out);
    EXPECT_EQ(advice["column"], "patch_displacement");
    EXPECT_EQ(advice["take"], "corotational_fem") << "compared with itself";
    EXPECT_EQ(advice["settings"][0]["error"], 0.0);
    const json load = named(advice["effects"], "key", "effects[0]");
    EXPECT_EQ(load["largest_without"], 0.0) << "what is not loaded is not measured to move";
    const json weight = named(advice["effects"], "key", "tissue.corotational_fem.gravity");
    EXPECT_GT(weight["changes"], 0.0);
    EXPECT_LT(weight["largest_without"], advice["largest"]) << "its weight presses the loaded patch down";
    EXPECT_THAT(advice["mind"][0].get<std::string>(), HasSubstr("load_shared_by=area"));
}

TEST(Advise, TakesForAnEffectOnlyWhatASceneCanDoWithout) {
    const Bench bench;
    const Outcome run = advised(bench, (scene_folder / "meshed" / "stiff_ball.yaml").string(),
                                {"--set", "run.duration=0.2 s", "--error", "99%", "--reference", "needle.type=rigid"});
    ASSERT_EQ(run.code, 0) << run.err;
    EXPECT_THAT(run.out, HasSubstr("effects[0] fracture"));
    EXPECT_THAT(run.out, Not(HasSubstr("mesh_unit")));
    EXPECT_THAT(run.out, HasSubstr("never came into play")) << "the tip does not get so far";
}

TEST(Advise, LeavesOutWhatMakesNoSceneAndSaysSo) {
    const Bench bench;
    const Outcome run =
        advised(bench, paper("fig10a_l150"),
                {"--set", "device.motion=[{insert: 5 mm, speed: 100 mm/s}]", "--set", "needle.corotational_fem={}", "--set",
                 "coupling.contact_spacing=0.2 mm", "--reference", "needle.type=rigid"});
    EXPECT_EQ(run.code, 2) << run.out;
    EXPECT_THAT(run.err, HasSubstr("needle.corotational_fem"));
    // At twice as many contacts the needle would have too many of them.
    const Outcome close = advised(bench, (scene_folder / "mock" / "surge.yaml").string(),
                                  {"--set", "device.motion=[{insert: 5 mm, speed: 100 mm/s}]", "--set",
                                   "coupling.contact_spacing=2 mm", "--reference", "needle.type=rigid"});
    ASSERT_EQ(close.code, 0) << close.err;
    EXPECT_THAT(close.out, ContainsRegex("left out: coupling.contact_spacing=1 mm: .*wanted at least"));
}

TEST(Advise, ComparesWithTheReferenceThatIsAskedFor) {
    const Bench bench;
    const Outcome run = advised(
        bench, column,
        {"--set", "run.duration=0.05 s", "--reference", "needle.type=elastica", "--reference", "run.rate=500 Hz", "--json", "-"});
    ASSERT_EQ(run.code, 0) << run.err;
    const json reference = json::parse(run.out)["reference"];
    EXPECT_EQ(reference["name"], "the scene with needle.type=elastica, run.rate=500 Hz");
    EXPECT_EQ(reference["set"]["needle.type"], "elastica");
}

TEST(Advise, SaysWhereThereIsNothingToCompare) {
    const Outcome run = advised(Bench(), block, {"--set", "effects=[]", "--set", "run.duration=0.005 s"});
    EXPECT_EQ(run.code, 2);
    EXPECT_THAT(run.err, AllOf(StartsWith(block + ": patch_displacement is 0 all along in the reference, "),
                               HasSubstr("there is nothing to compare")));
}

TEST(AdviseRefuses, AWrongCommandLineInASentence) {
    struct Wrong {
        std::vector<std::string> arguments;
        const char* message;
    };
    const Wrong wrongs[] = {
        {{"--budget", "1"}, "--budget: found '1' without a unit, wanted a time for a tick, above 0, such as '1 ms'\n"},
        {{"--budget", "1 mm"}, "--budget: found '1 mm', wanted a time for a tick, above 0, such as '1 ms'\n"},
        {{"--budget", "-1 ms"}, "--budget: found '-1 ms', wanted a time for a tick, above 0, such as '1 ms'\n"},
        {{"--error", "5"}, "--error: found '5', wanted a share between 0 and 1 such as 5% or 0.05\n"},
        {{"--error", "0 %"}, "--error: found '0 %', wanted a share between 0 and 1 such as 5% or 0.05\n"},
        {{"--error", "5 per cent"}, "--error: found '5 per cent', wanted a share between 0 and 1 such as 5% or 0.05\n"},
        {{"--error", "nan"}, "--error: found 'nan', wanted a share between 0 and 1 such as 5% or 0.05\n"},
        {{"--reference", "rod"}, "--reference: found 'rod', wanted KEY=VALUE, for instance needle.type=rod\n"},
    };
    for (const Wrong& wrong : wrongs) {
        std::vector<std::string> arguments{"advise", column};
        arguments.insert(arguments.end(), wrong.arguments.begin(), wrong.arguments.end());
        const Outcome refused = Bench().stylet(arguments);
        EXPECT_EQ(refused.code, 3) << wrong.arguments.back();
        EXPECT_EQ(refused.err, wrong.message);
        EXPECT_THAT(refused.out, IsEmpty());
    }
}

TEST(AdviseRefuses, AWrongSceneOrReferenceBeforeAnythingIsRun) {
    const Outcome scene = advised(Bench(), column, {"--set", "needle.radius=0.3"});
    EXPECT_EQ(scene.code, 2);
    EXPECT_THAT(scene.err, StartsWith("--set needle.radius: found '0.3' without a unit"));
    const Bench bench;
    EXPECT_EQ(advised(bench, column, {"--set", "needle.radius=0.3", "--json", "advice.json"}).code, 2);
    EXPECT_FALSE(bench.has("advice.json")) << "nothing was advised";
    const Outcome reference = advised(Bench(), column, {"--reference", "nedle.type=rod"});
    EXPECT_EQ(reference.code, 2);
    EXPECT_EQ(reference.err, "--reference nedle.type: found no key 'nedle' in the scene; did you mean 'needle'?\n");
}

TEST(AdviseRefuses, AFileThatCannotBeWrittenBeforeAnythingIsRun) {
    const Outcome refused = advised(Bench(), column, {"--json", "nowhere/advice.json"});
    EXPECT_EQ(refused.code, 4);
    EXPECT_THAT(refused.err, HasSubstr("nowhere/advice.json"));
    EXPECT_THAT(refused.out, IsEmpty());
}

TEST(AdviseRefuses, TwoScenes) {
    const Outcome refused = Bench().stylet({"advise", column, block});
    EXPECT_EQ(refused.code, 3);
    EXPECT_THAT(refused.err, StartsWith("SCENE: "));
}

/// The process has taken Ctrl-C upon itself: its runs have begun.
bool catches_interrupts(int process) {
    std::ifstream status("/proc/" + std::to_string(process) + "/status");
    const std::string name = "SigCgt:";
    for (std::string line; std::getline(status, line);) {
        if (line.starts_with(name)) return (std::stoull(line.substr(name.size()), nullptr, 16) & (1U << (SIGINT - 1))) != 0;
    }
    return false;
}

TEST(Advise, IsStoppedByCtrlCAndLeavesFilesAsTheyWere) {
    namespace process = boost::process;
    const Bench bench;
    bench.write("advice.json", "of yesterday");
    process::child run(process::exe = STYLET_EXECUTABLE,
                       process::args({"advise", column, "--set", "run.duration=100000 s", "--json", "advice.json"}),
                       process::start_dir(bench.path("").string()), process::std_out > bench.path("out"),
                       process::std_err > bench.path("err").string());
    while (run.running() && !catches_interrupts(run.id())) std::this_thread::sleep_for(std::chrono::milliseconds(5));
    kill(run.id(), SIGINT);
    run.wait();
    EXPECT_EQ(run.exit_code(), 130);
    EXPECT_THAT(bench.read("err"), HasSubstr("stopped by Ctrl-C"));
    EXPECT_THAT(bench.read("out"), IsEmpty());
    EXPECT_EQ(bench.read("advice.json"), "of yesterday");
}

}    // namespace
}    // namespace stylet::commands
