#include "apps/study/recording_file.h"
#include "apps/stylet/command.h"
#include "apps/stylet/gnuplot.h"

#include <fmt/format.h>

#include <memory>
#include <optional>

namespace stylet::app {
namespace {

namespace fs = std::filesystem;

constexpr const char* examples =
    R"(Draws the hand's force against the tip's depth, with the events marked and named, as STEM.svg and STEM.png. Several
recordings share one picture, with the recordings' titles as the legend. Any two recorded columns can be the axes: travel,
depth, inserted, time; hand_force, tip_force, friction_force, critical_load, deflection, hand_work, ...

Examples:
  stylet plot out/fig9.csv
  stylet plot out/fig10a_l*.csv --x travel --out out/fig10a
  stylet plot out/fig9.csv --x time --y deflection --title 'How far the needle bows'

Exit codes: 0 ok, 2 a recording is wrong or lacks a column, 3 wrong command line, 4 gnuplot is missing or a file cannot be
written.)";

struct PlotArguments {
    std::vector<std::string> recordings;
    std::string out;
    std::string x = "depth";
    std::string y = "hand_force";
    std::optional<std::string> title;
};

/// Both pictures' names begin with this: what the user gave, or the first recording's place and stem.
fs::path stem_of(const PlotArguments& arguments) {
    if (arguments.out.empty()) return fs::path(arguments.recordings.front()).replace_extension();
    const fs::path out = arguments.out;
    return out.extension() == ".svg" || out.extension() == ".png" ? fs::path(out).replace_extension() : out;
}

ExitCode plot(const PlotArguments& arguments) {
    std::vector<study::Recording> recordings;
    for (const std::string& file : arguments.recordings) recordings.push_back(study::read_recording(file));
    Figure figure = figure_of(recordings, arguments.x, arguments.y);
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
    options->add_option("--x", arguments->x, "Column for the horizontal axis")->type_name("COLUMN")->capture_default_str();
    options->add_option("--y", arguments->y, "Column for the vertical axis")->type_name("COLUMN")->capture_default_str();
    options
        ->add_option("--title", arguments->title, "Title above the picture; without it, a single recording's title. Empty: none")
        ->type_name("TEXT");
    return {options, [arguments] { return plot(*arguments); }};
}

}    // namespace stylet::app
