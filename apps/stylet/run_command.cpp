#include "core/export/scene_series.h"
#include "core/run/run.h"
#include "core/scene/complaints.h"
#include "core/scene/units.h"
#include "core/workers/worker_pool.h"

#include "apps/stylet/command.h"
#include "apps/stylet/failure.h"
#include "apps/stylet/interrupt.h"
#include "apps/stylet/output.h"
#include "apps/stylet/progress_bar.h"
#include "apps/stylet/scene_arguments.h"
#include "apps/stylet/summary.h"

#include <fmt/format.h>

#include <map>
#include <memory>
#include <optional>

namespace stylet::app {
namespace {

namespace fs = std::filesystem;

constexpr const char* examples =
    R"(Runs each scene to its end and writes FOLDER/<scene>.csv, a row for each tick, while it goes. Ends with a
summary: events, peak force, when the needle buckled and at what load, the energy ledger, the time a tick took.
With --vtu it also leaves pictures for ParaView and its kin: FOLDER/<scene>_tissue.pvd, _needle.pvd and _contacts.pvd, each an
animation. Tissue is drawn where it is; its points minus its array `displacement` are where it was undeformed.
With --real-time each tick comes at its own moment of the wall clock, as a hand would feel it: on a thread of its own, SCHED_FIFO
and with all memory locked where the system allows it (otherwise it says so and goes on without). Ctrl-C ends a run early and
keeps what was done.
Plugins are looked for in each --plugin-dir, then in the folders of STYLET_PLUGIN_PATH, then in the install.

Examples:
  stylet run scenes/paper/fig10a_l200.yaml
  stylet run scenes/paper/fig10a_l*.yaml --out results
  stylet run scenes/paper/fig9.yaml --set needle.length='180 mm' --set 'effects[0].rupture_force=0.7 N' --json fig9.json
  stylet run scenes/paper/fig9.yaml --json - | python3 -m json.tool
  stylet run scenes/paper/fig9.yaml --vtu pictures --vtu-rate '100 Hz'
  stylet run scenes/paper/fig9.yaml --real-time

Exit codes: 0 ok, 1 a run ended with a fault, 2 a scene is wrong (nothing is run then), 3 wrong command line,
4 a file cannot be written, 130 stopped by Ctrl-C.)";

struct RunArguments {
    SceneArguments scenes;
    std::string out = "out";
    std::string json;
    std::string vtu;
    std::string vtu_rate = "25 Hz";
    int threads = core::processors();
    bool real_time = false;
    bool quiet = false;
};

/// The recording of each scene, by its stem. Two scenes of one stem would write the same file.
std::vector<fs::path> recordings_of(const RunArguments& arguments) {
    std::map<std::string, std::string> taken;
    std::vector<fs::path> recordings;
    for (const std::string& file : arguments.scenes.files()) {
        const std::string stem = fs::path(file).stem().string();
        const auto [other, is_new] = taken.emplace(stem, file);
        if (!is_new) {
            throw Failure(ExitCode::wrong_command,
                          fmt::format("{} and {} would both be recorded as {}.csv; please run them one at a time "
                                      "with different --out folders",
                                      other->second, file, stem));
        }
        recordings.push_back(fs::path(arguments.out) / (stem + ".csv"));
    }
    return recordings;
}

/// All scenes are read before the first is run, so that all errors show at once.
std::vector<core::Scene> read_all(const SceneArguments& arguments) {
    const std::vector<core::Override> overrides = arguments.overrides();
    const core::PluginFolders folders = arguments.folders();
    std::vector<core::Scene> scenes;
    std::vector<std::string> messages;
    for (const std::string& file : arguments.files()) {
        try {
            scenes.push_back(core::read_scene(file, overrides, folders));
        } catch (const core::SceneErrors& errors) {
            messages.insert(messages.end(), errors.messages().begin(), errors.messages().end());
        }
    }
    if (!messages.empty()) throw core::SceneErrors(messages);
    return scenes;
}

/// What --vtu asks for.
struct Pictures {
    fs::path folder;
    double rate;    // [Hz]
};

std::optional<Pictures> pictures_of(const RunArguments& arguments) {
    if (arguments.vtu.empty()) return std::nullopt;
    const core::Quantity rate = core::read_quantity(arguments.vtu_rate, "Hz");
    if (!rate.problem.empty() || !(rate.value > 0.0)) {
        const std::string found = rate.problem.empty() ? core::quote(arguments.vtu_rate) : rate.problem;
        throw Failure(ExitCode::wrong_command,
                      fmt::format("--vtu-rate: found {}, wanted {}, above 0", found, core::wanted_quantity("Hz")));
    }
    return Pictures{arguments.vtu, rate.value};
}

std::optional<FinishedSeries> finished(const std::optional<core::SceneSeries>& series) {
    if (!series) return std::nullopt;
    return FinishedSeries{.files = series->files(), .moments = series->moments(), .period = series->period()};
}

FinishedRun run_one(const core::Scene& scene, const std::string& name, const fs::path& recording,
                    const std::optional<Pictures>& pictures, const RunArguments& arguments) {
    ProgressBar bar(name);
    core::RunOptions options;
    options.recording = recording;
    options.threads = arguments.threads;
    options.stop = &Interrupt::asked();
    if (!arguments.quiet) options.progress = [&bar](double fraction) { bar.show(fraction); };
    try {
        std::optional<core::SceneSeries> series;
        if (pictures) {
            series.emplace(scene, pictures->folder, fs::path(name).stem().string(), pictures->rate);
            options.observe = [&series](const core::Simulation& simulation) { series->observe(simulation); };
        }
        const auto play = arguments.real_time ? core::run_in_real_time : core::run;
        core::RunReport report = play(scene, arguments.scenes.folders(), options);
        return {name, recording.string(), std::move(report), finished(series)};
    } catch (const Error& error) {    // with a key it is the scene's fault, without one a file's
        if (error.key().empty()) throw Failure(ExitCode::missing, error.what());
        throw Failure(ExitCode::wrong_input, fmt::format("{}: {}: {}", name, error.key(), error.what()));
    }
}

void report(const FinishedRun& run, const RunArguments& arguments, bool first) {
    const bool json_on_stdout = arguments.json == "-";
    if (!arguments.quiet && !json_on_stdout) fmt::print("{}{}", first ? "" : "\n", summary_text(run));
    if (arguments.json.empty()) return;
    const std::string text = summary_json(run);
    if (json_on_stdout) {
        fmt::print("{}", text);
    } else {
        write_file(arguments.json, text);
    }
}

ExitCode run_all(const RunArguments& arguments) {
    const std::vector<std::string>& names = arguments.scenes.files();
    if (!arguments.json.empty() && names.size() > 1) {
        throw Failure(ExitCode::wrong_command, fmt::format("--json: found {} scenes, wanted one", names.size()));
    }
    const std::vector<fs::path> recordings = recordings_of(arguments);
    const std::optional<Pictures> pictures = pictures_of(arguments);
    const std::vector<core::Scene> scenes = read_all(arguments.scenes);
    make_folder(arguments.out);
    if (pictures) make_folder(pictures->folder);
    for (const fs::path& recording : recordings) expect_writable(recording);
    if (!arguments.json.empty() && arguments.json != "-") expect_writable(arguments.json);

    const Interrupt interrupt;
    bool fault = false;
    std::size_t played = 0;
    for (; played < scenes.size() && !Interrupt::asked(); ++played) {
        const FinishedRun run = run_one(scenes[played], names[played], recordings[played], pictures, arguments);
        report(run, arguments, played == 0);
        fault |= ended_in_fault(run.report);
    }
    if (Interrupt::asked()) {
        for (std::size_t i = played; i < scenes.size(); ++i) {
            fmt::print(stderr, "{}: not run: stopped by Ctrl-C\n", names[i]);
            fs::remove(recordings[i]);    // which was only tried
        }
        return ExitCode::interrupted;
    }
    return fault ? ExitCode::fault : ExitCode::ok;
}

}    // namespace

Command run_command(CLI::App& line) {
    const auto arguments = std::make_shared<RunArguments>();
    CLI::App* options = line.add_subcommand("run", "Run scenes, record them, sum them up");
    options->footer(examples);
    arguments->scenes.add_to(*options);
    options->add_option("--out", arguments->out, "Folder for the recordings")->type_name("FOLDER")->capture_default_str();
    options->add_option("--json", arguments->json, "The summary of the one scene as JSON; - for stdout, without the text")
        ->type_name("FILE");
    CLI::Option* vtu = options->add_option("--vtu", arguments->vtu, "Folder for VTU and PVD files of tissue and needle");
    vtu->type_name("FOLDER");
    options->add_option("--vtu-rate", arguments->vtu_rate, "Pictures a simulated second, to the nearest whole tick")
        ->type_name("RATE")
        ->needs(vtu)
        ->capture_default_str();
    options->add_flag("--real-time", arguments->real_time, "Each tick at its own moment of the wall clock")->excludes(vtu);
    options
        ->add_option("--threads", arguments->threads, "That models may share their work among; left out, one for each processor")
        ->type_name("N")
        ->check(CLI::Range(1, 256));
    options->add_flag("--quiet", arguments->quiet, "No progress bar and no summary");
    return {options, [arguments] { return run_all(*arguments); }};
}

}    // namespace stylet::app
