#include "apps/study/recording_file.h"
#include "apps/stylet/command.h"
#include "apps/stylet/gnuplot.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>

namespace stylet::app {
namespace {

namespace fs = std::filesystem;

constexpr const char* examples =
    R"(Draws the hand's force against the tip's depth, with the events marked and named, as STEM.svg and STEM.png; of a tissue alone
how far its loaded patch moves in time. Several recordings share one picture, with the recordings' titles as the legend. Any two
recorded columns can be the axes: travel, depth, inserted, time; hand_force, tip_force, friction_force, critical_load, deflection,
hand_work, ...

Examples:
  stylet plot out/fig9.csv
  stylet plot out/fig10a_l*.csv --x travel --out out/fig10a
  stylet plot out/fig9.csv --x time --y deflection --title 'How far the needle bows'
  stylet plot out/block_m2.csv

Exit codes: 0 ok, 2 a recording is wrong or lacks a column, 3 wrong command line, 4 gnuplot is missing or a file cannot be
written.)";

struct PlotArguments {
    std::vector<std::string> recordings;
    std::string out;
    std::string x, y;    // empty: what is drawn of such recordings
    std::optional<std::string> title;
};

/// Both pictures' names begin with this: what the user gave, or the first recording's place and stem.
fs::path stem_of(const PlotArguments& arguments) {
    if (arguments.out.empty()) return fs::path(arguments.recordings.front()).replace_extension();
    const fs::path out = arguments.out;
    return out.extension() == ".svg" || out.extension() == ".png" ? fs::path(out).replace_extension() : out;
}

/// Of a tissue alone.
bool is_without_needle(const study::Recording& recording) {
    return std::ranges::find(recording.columns, "patch_displacement", &study::RecordedColumn::name) != recording.columns.end();
}

ExitCode plot(const PlotArguments& arguments) {
    std::vector<study::Recording> recordings;
    for (const std::string& file : arguments.recordings) recordings.push_back(study::read_recording(file));
    const bool of_tissue = std::ranges::all_of(recordings, is_without_needle);
    const auto or_else = [](const std::string& asked, const char* otherwise) { return asked.empty() ? otherwise : asked; };
    Figure figure = figure_of(recordings, or_else(arguments.x, of_tissue ? "time" : "depth"),
                              or_else(arguments.y, of_tissue ? "patch_displacement" : "hand_force"));
    if (arguments.title) figure.title = *arguments.title;
    const PictureFiles files = draw(figure, stem_of(arguments));
    fmt::print("{}\n{}\n", files.svg.string(), files.png.string());
    return ExitCode::ok;
}

}    // namespace

Command plot_command(CLI::App& line) {
    const auto arguments = std::make_shared<PlotArguments>();
    CLI::App* options = line.add_subcommand("plot", "Draw recordings: force against depth, events marked");
    options->footer(examples);
    options->add_option("RECORDING", arguments->recordings, "Recordings to draw, in the order of the legend")
        ->required()
        ->type_name("FILE");
    options->add_option("--out", arguments->out, "Beginning of the pictures' names; without it, the first recording's")
        ->type_name("STEM");
    options->add_option("--x", arguments->x, "Column for the horizontal axis; without it depth, or time where there is no needle")
        ->type_name("COLUMN");
    options
        ->add_option("--y", arguments->y,
                     "Column for the vertical axis; without it hand_force, or patch_displacement where there is no needle")
        ->type_name("COLUMN");
    options
        ->add_option("--title", arguments->title, "Title above the picture; without it, a single recording's title. Empty: none")
        ->type_name("TEXT");
    return {options, [arguments] { return plot(*arguments); }};
}

}    // namespace stylet::app
