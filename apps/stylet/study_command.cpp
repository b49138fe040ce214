#include "apps/study/run_study.h"
#include "apps/study/study_reader.h"
#include "apps/stylet/command.h"
#include "apps/stylet/failure.h"
#include "apps/stylet/interrupt.h"
#include "apps/stylet/output.h"
#include "apps/stylet/scene_arguments.h"
#include "apps/stylet/shell_word.h"
#include "apps/stylet/study_csv.h"
#include "apps/stylet/study_figure.h"
#include "apps/stylet/study_page.h"
#include "apps/stylet/study_progress.h"
#include "apps/stylet/study_text.h"
#include "core/scene/complaints.h"

#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <optional>

namespace stylet::app {
namespace {

namespace fs = std::filesystem;

constexpr const char* examples =
    R"(Runs every setting that the study names, compares each with the reference and times it: what accuracy costs. Leaves in FOLDER
<study>.csv, <study>.md with <study>.png and <study>.svg, and <study>.runs.jsonl with what each run gave: stopped by Ctrl-C or by
anything else, the same command goes on where it was. Ends with the cheapest setting under 1 %, under 5 %, and the most accurate
within 1 ms. Times are only as good as the machine is quiet: what had to wait for it is run again, or marked.

Examples:
  stylet study scenes/studies/critical_load.yaml
  stylet study scenes/studies/time_step.yaml --out results
  stylet study scenes/studies/time_step.yaml --again

Exit codes: 0 ok, 2 the study or one of its scenes is wrong (nothing is run then), 3 wrong command line, 4 gnuplot is missing or a
file cannot be written, 130 stopped by Ctrl-C.)";

struct StudyArguments {
    std::string file;
    std::string out = "out";
    std::vector<std::string> plugin_dirs;
    bool again = false;
    bool quiet = false;
};

/// The files that a study leaves.
struct StudyFiles {
    fs::path stem;    // of all of them

    [[nodiscard]] fs::path with(const char* ending) const { return stem.string() + ending; }
};

study::Result run(const study::Study& study, const StudyArguments& arguments, const fs::path& log) {
    StudyProgress bar(study.title);
    const study::Options options{.folders = plugin_folders(arguments.plugin_dirs),
                                 .log = log,
                                 .again = arguments.again,
                                 .progress =
                                     [&](const study::Progress& progress) {
                                         if (!arguments.quiet) bar.show(progress);
                                     },
                                 .stop = &Interrupt::asked()};
    return study::run_study(study, options);
}

/// What makes the page again.
std::string command_of(const StudyArguments& arguments) {
    std::string command = fmt::format("stylet study {} --out {}", shell_word(arguments.file), shell_word(arguments.out));
    for (const std::string& folder : arguments.plugin_dirs) command += " --plugin-dir " + shell_word(folder);
    return command;
}

ExitCode stopped(const StudyArguments& arguments) {
    fmt::print(stderr, "{}: stopped by Ctrl-C; the same command goes on where it was\n", arguments.file);
    return ExitCode::interrupted;
}

/// Nothing where Ctrl-C, which gnuplot hears too, has ended it.
std::optional<PictureFiles> drawn(const study::Result& result, const fs::path& stem) {
    try {
        return draw_study(result, stem);
    } catch (const Failure&) {
        if (!Interrupt::asked()) throw;
        return std::nullopt;
    }
}

ExitCode conduct(const StudyArguments& arguments) {
    const study::Study study = study::read_study(arguments.file, plugin_folders(arguments.plugin_dirs));
    make_folder(arguments.out);
    const StudyFiles files{fs::path(arguments.out) / fs::path(arguments.file).stem()};
    for (const char* ending : {".csv", ".md", ".png", ".svg", ".runs.jsonl"}) expect_writable_later(files.with(ending));
    const fs::path log = files.with(".runs.jsonl");

    const Interrupt interrupt;
    study::Result result = run(study, arguments, log);
    result.command = command_of(arguments);
    if (!arguments.quiet && !result.settings.empty()) fmt::print("{}", study_text(result));
    if (result.stopped) return stopped(arguments);
    write_file(files.with(".csv"), study_csv(result));
    const std::optional<PictureFiles> pictures = drawn(result, files.stem);
    if (!pictures) return stopped(arguments);
    write_file(files.with(".md"), study_page(result, pictures->png.filename().string()));
    if (!arguments.quiet)
        fmt::print("\n{}\n{}\n{}\n{}\n", files.with(".md").string(), files.with(".csv").string(), pictures->svg.string(),
                   pictures->png.string());
    return ExitCode::ok;
}

}    // namespace

Command study_command(CLI::App& line) {
    const auto arguments = std::make_shared<StudyArguments>();
    CLI::App* options = line.add_subcommand("study", "Show what accuracy costs in time: settings against a reference");
    options->footer(examples);
    options->add_option("STUDY", arguments->file, "The study to run")->required()->type_name("FILE");
    options->add_option("--out", arguments->out, "Folder for what it leaves")->type_name("FOLDER")->capture_default_str();
    options->add_flag("--again", arguments->again, "Measure everything anew, also what an earlier run has measured");
    options->add_flag("--quiet", arguments->quiet, "No progress bar, no table");
    add_plugin_dir(*options, arguments->plugin_dirs);
    return {options, [arguments] { return conduct(*arguments); }};
}

}    // namespace stylet::app
