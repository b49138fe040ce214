// Only what a scene calls for is in the process, and costs anything.
#include "tests/commands/command.h"
#include "tests/whole_scenes/trace.h"

#include <nlohmann/json.hpp>

#include <boost/process/args.hpp>
#include <boost/process/env.hpp>
#include <boost/process/exe.hpp>
#include <boost/process/io.hpp>
#include <boost/process/start_dir.hpp>
#include <boost/process/system.hpp>

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

namespace stylet::whole_scenes {
namespace {

const core::Override flexible{"needle.type", "beam_column"};
const core::Override may_buckle{"needle.buckling", "{type: euler}"};
const core::Override short_stroke{"device.cycles", "1"};

/// The plugins mapped into this process, by name.
std::vector<std::string> mapped_plugins() {
    std::vector<std::string> names;
    std::ifstream maps("/proc/self/maps");
    for (std::string line; std::getline(maps, line);) {
        const auto path = line.find('/');
        if (path == std::string::npos) continue;
        const std::filesystem::path file = line.substr(path);
        if (file.parent_path() != PLUGIN_FOLDER) continue;
        if (std::ranges::find(names, file.stem().string()) == names.end()) names.push_back(file.stem().string());
    }
    std::ranges::sort(names);
    return names;
}

TEST(Libraries, AreAllGoneOnceASceneIsRead) {
    for (const char* name : {"fig9", "fig10a_l150"}) (void)core::read_scene(paper_scene(name), {}, plugin_folders());
    EXPECT_EQ(mapped_plugins(), std::vector<std::string>{});
}

TEST(Libraries, AreThoseThatTheSceneNamesWhileItRunsAndNoneAfter) {
    {
        Stage stage(own_scene("stroke"), {flexible, short_stroke});
        (void)play(stage);
        EXPECT_EQ(mapped_plugins(),
                  (std::vector<std::string>{"beam_column", "fracture", "friction", "half_space", "recorded_hand"}));
    }
    EXPECT_EQ(mapped_plugins(), std::vector<std::string>{});
}

TEST(Libraries, IncludeTheBucklingLibraryWhereTheSceneAsksForIt) {
    Stage stage(own_scene("stroke"), {flexible, may_buckle, short_stroke});
    (void)play(stage);
    EXPECT_EQ(mapped_plugins(),
              (std::vector<std::string>{"beam_column", "euler", "fracture", "friction", "half_space", "recorded_hand"}));
}

std::vector<std::string> libraries_of_summary(const std::vector<std::string>& more) {
    const commands::Bench bench;
    std::vector<std::string> arguments{"run",   own_scene("stroke").string(), "--json", "-", "--set", "device.cycles=1",
                                       "--set", "needle.type=beam_column"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const commands::Outcome outcome = bench.stylet(arguments);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    std::vector<std::string> names;
    const nlohmann::json summary = nlohmann::json::parse(outcome.out);
    for (const auto& library : summary.at("libraries")) {
        names.push_back(std::filesystem::path(library.get<std::string>()).stem().string());
    }
    return names;
}

TEST(Summary, ListsABucklingLibraryOnlyWhereTheSceneAsksForIt) {
    EXPECT_EQ(std::ranges::count(libraries_of_summary({}), "euler"), 0);
    EXPECT_EQ(std::ranges::count(libraries_of_summary({"--set", "needle.buckling={type: euler}"}), "euler"), 1);
}

/// An install of the test's own, so that a library can be missing from it.
class Install {
public:
    Install() {
        std::filesystem::create_directories(plugins());
        std::filesystem::create_directory(bench_.path("bin"));
        std::filesystem::copy_file(STYLET_EXECUTABLE, bench_.path("bin/stylet"));
        for (const char* name : {"beam_column", "fracture", "friction", "half_space", "recorded_hand"}) add(name);
    }
    void add(const std::string& name) const {
        std::filesystem::copy_file(std::filesystem::path(PLUGIN_FOLDER) / (name + ".so"), plugins() / (name + ".so"));
    }

    /// Instructions of a short run: all that main does, loading included. The recorder's own thread is left out, for it looks at
    /// its ring every few milliseconds of wall time. 0 where the run failed.
    [[nodiscard]] double instructions() const {
        namespace process = boost::process;
        process::environment environment = boost::this_process::environment();
        environment.erase("STYLET_PLUGIN_PATH");
        const std::string counts = bench_.path("callgrind.out").string();
        const std::vector<std::string> arguments{"--tool=callgrind",
                                                 "--toggle-collect=main",
                                                 "--callgrind-out-file=" + counts,
                                                 bench_.path("bin/stylet").string(),
                                                 "run",
                                                 own_scene("stroke").string(),
                                                 "--set",
                                                 "needle.type=beam_column",
                                                 "--set",
                                                 "device.cycles=1",
                                                 "--set",
                                                 "run.duration=0.3 s",
                                                 "--quiet"};
        const int code = process::system(process::exe = VALGRIND_EXECUTABLE, process::args(arguments), environment,
                                         process::start_dir(bench_.path("").string()),
                                         (process::std_out & process::std_err) > bench_.path("valgrind.log").string());
        EXPECT_EQ(code, 0) << bench_.read("valgrind.log");
        std::ifstream file(counts);
        for (std::string line; std::getline(file, line);) {
            if (line.starts_with("totals: ")) return std::stod(line.substr(8));
        }
        ADD_FAILURE() << "callgrind wrote no totals";
        return 0.0;
    }

private:
    [[nodiscard]] std::filesystem::path plugins() const { return bench_.path("lib/stylet/plugins"); }

    commands::Bench bench_;
};

TEST(Instructions, AreTheSameWhetherOrNotABucklingLibraryLiesInThePluginFolder) {
    constexpr double most_difference = 1e-3;    // relative: the bound
    const Install install;
    const double without = install.instructions();
    install.add("euler");
    const double with = install.instructions();
    measured("without", without);
    measured("with", with);
    measured("difference", with / without - 1.0);
    EXPECT_GT(without, 1e7) << "that was no run";
    EXPECT_NEAR(with / without, 1.0, most_difference);
}

}    // namespace
}    // namespace stylet::whole_scenes
