// What a scene does not name costs nothing, counted by callgrind. Left out of builds with sanitizers, which valgrind cannot run.
#include "tests/commands/command.h"
#include "tests/whole_scenes/trace.h"

#include <boost/process/args.hpp>
#include <boost/process/env.hpp>
#include <boost/process/exe.hpp>
#include <boost/process/io.hpp>
#include <boost/process/start_dir.hpp>
#include <boost/process/system.hpp>

#include <gtest/gtest.h>

#include <fstream>

namespace stylet::whole_scenes {
namespace {

/// An install of the test's own, so that a library can be missing from it.
class Install {
public:
    Install() {
        std::filesystem::create_directories(plugins());
        std::filesystem::create_directory(bench_.path("bin"));
        std::filesystem::copy_file(STYLET_EXECUTABLE, bench_.path("bin/stylet"));
        for (const char* name : {"beam_column", "fracture", "friction", "half_space", "recorded_hand", "rod"}) add(name);
    }
    void add(const std::string& name) const {
        std::filesystem::copy_file(std::filesystem::path(PLUGIN_FOLDER) / (name + ".so"), plugins() / (name + ".so"));
    }

    /// Instructions of a run of ten cycles: of reading its scene, loading its cast and all ticks. What else the process does
    /// depends on the clock: the recorder's thread looks at its ring every few milliseconds, and tick times are sorted. Ten,
    /// because expat salts its hashes at random, which makes reading the units dearer or cheaper by some 50 000 instructions. 0
    /// where it failed.
    [[nodiscard]] double instructions() const {
        namespace process = boost::process;
        process::environment environment = boost::this_process::environment();
        environment.erase("STYLET_PLUGIN_PATH");
        const std::string counts = bench_.path("callgrind.out").string();
        const std::vector<std::string> arguments{"--tool=callgrind",
                                                 "--toggle-collect=stylet::core::read_scene(*",
                                                 "--toggle-collect=stylet::core::Cast::Cast(*",
                                                 "--toggle-collect=stylet::core::Simulation::tick(double)",
                                                 "--callgrind-out-file=" + counts,
                                                 bench_.path("bin/stylet").string(),
                                                 "run",
                                                 own_scene("stroke").string(),
                                                 "--set",
                                                 "needle.type=beam_column",
                                                 "--set",
                                                 "device.cycles=10",
                                                 "--threads",
                                                 "1",    // another thread looks for work as long as it likes
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
