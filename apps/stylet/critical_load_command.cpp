#include "apps/stylet/command.h"
#include "apps/stylet/critical_loads.h"
#include "apps/stylet/failure.h"
#include "apps/stylet/gnuplot.h"
#include "apps/stylet/load_figure.h"
#include "apps/stylet/load_files.h"
#include "apps/stylet/load_text.h"
#include "apps/stylet/output.h"
#include "apps/stylet/reference_loads.h"
#include "apps/stylet/scene_arguments.h"
#include "core/scene/complaints.h"
#include "core/scene/units.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <set>

namespace stylet::app {
namespace {

namespace fs = std::filesystem;

constexpr const char* examples =
    R"(Tells at which force the needle buckles, by each named model, while it goes in at a right angle: from the tip on the surface to
all of it inside, or at one depth. Depth is the length of needle inserted, without the dent that a run's tip first makes. Beneath
the table: whether it buckles before the tip punctures, if the scene's effects say at which force that is, and whether it bears
what cutting and friction ask for inside: the friction of a shaft at rest, in tissue that is not drawn along.
Without --model, the scene's own model is asked and every other that its section holds a map for. A model's parameters come from
its map, and from KEY=VALUE after its name; the same model may be asked twice. A scene without 'buckling' will do with --model.
With --vary, a key of the scene takes the place of depth: any that --set may change, in small steps.

Examples:
  stylet critical-load scenes/paper/fig10a_l200.yaml
  stylet critical-load scenes/paper/fig10a_l200.yaml --depth 0..60mm --plot out/insertion
  stylet critical-load scenes/paper/fig3.yaml --vary needle.radius=0.1..1mm --plot out/fig3a
  stylet critical-load scenes/paper/table1_row1.yaml --depth '50 mm' --model foundation,form=printed --model winkler
  stylet critical-load scenes/paper/table*.yaml --depth '50 mm' --reference scenes/paper/tables.csv
  stylet critical-load scenes/paper/fig3.yaml --json - | python3 -m json.tool

Exit codes: 0 ok, 2 a scene, a model or a depth is wrong, 3 wrong command line, 4 gnuplot is missing or a file cannot be
written.)";

constexpr int most_points = 10000;

struct LoadArguments {
    SceneArguments scenes;
    std::vector<std::string> models;
    // Each once or not at all; CLI11 would refuse a second one in words of its own.
    std::vector<std::string> depth, vary, reference, json, csv, plot;
    std::optional<int> points;
    bool stiffness = false;
};

/// What was given to an option that may come once; nothing where it did not.
std::optional<std::string> only(const char* option, const std::vector<std::string>& given) {
    if (given.empty()) return std::nullopt;
    if (given.size() > 1)
        throw Failure(ExitCode::wrong_command, fmt::format("{}: found it {} times, wanted it once", option, given.size()));
    if (given.front().empty()) throw Failure(ExitCode::wrong_command, fmt::format("{}: found '', wanted a value", option));
    return given.front();
}

std::vector<AskedModel> asked_models(const std::vector<std::string>& texts) {
    std::vector<AskedModel> models;
    std::set<std::string> labels;
    for (const std::string& text : texts) {
        models.push_back(read_asked_model(text));
        if (labels.insert(models.back().label()).second) continue;
        throw Failure(ExitCode::wrong_command,
                      fmt::format("--model: found {} a second time, wanted each once", core::quote(text)));
    }
    return models;
}

study::Interval read_interval(const char* option, const std::string& text) {
    try {
        return study::read_interval(text);
    } catch (const Error& error) {
        throw Failure(ExitCode::wrong_command, fmt::format("{}: {}", option, error.what()));
    }
}

VariedKey varied_key(const std::string& text) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos || equals == 0) {
        throw Failure(
            ExitCode::wrong_command,
            fmt::format("--vary: found {}, wanted KEY=FROM..TO, for instance needle.radius=0.1..1mm", core::quote(text)));
    }
    VariedKey varied{text.substr(0, equals), read_interval("--vary", text.substr(equals + 1))};
    if (!varied.values.one_value()) return varied;
    throw Failure(
        ExitCode::wrong_command,
        fmt::format("--vary: found {}, wanted an interval such as 0.1..1mm (--set gives one value)", core::quote(text)));
}

study::Interval depth_of(const std::string& text) {
    study::Interval depth = read_interval("--depth", text);
    const core::Quantity quantity = core::read_quantity(depth.quantity(depth.to), "m");
    if (quantity.problem.empty()) return depth;
    throw Failure(ExitCode::wrong_command, fmt::format("--depth: found {}, wanted {}, or an interval such as 0..50mm",
                                                       quantity.problem, core::wanted_quantity("m")));
}

/// A model's own parameter stays what --model says.
void refuse_clash(const VariedKey& varied, const std::vector<AskedModel>& models) {
    for (const AskedModel& model : models) {
        const auto clash = std::ranges::find(model.overrides, varied.key, &core::Override::key);
        if (clash == model.overrides.end()) continue;
        throw Failure(ExitCode::wrong_command, fmt::format("--vary: found {}, which {} sets, wanted one of the two",
                                                           core::quote(varied.key), clash->given));
    }
}

LoadQuestion question_of(const LoadArguments& arguments) {
    LoadQuestion question{.scenes = arguments.scenes.files(),
                          .overrides = arguments.scenes.overrides(),
                          .folders = arguments.scenes.folders(),
                          .models = asked_models(arguments.models),
                          .depth = {},
                          .varied = {},
                          .stiffness = arguments.stiffness};
    const auto depth = only("--depth", arguments.depth), vary = only("--vary", arguments.vary);
    if (depth) question.depth = depth_of(*depth);
    if (vary) question.varied = varied_key(*vary);
    if (question.varied) refuse_clash(*question.varied, question.models);
    if (question.varied && question.depth && !question.depth->one_value()) {
        throw Failure(
            ExitCode::wrong_command,
            fmt::format("--depth: found {} beside --vary, wanted one depth: a picture has one axis", core::quote(*depth)));
    }
    const bool one_depth = !question.varied && question.depth && question.depth->one_value();
    if (arguments.points && one_depth)
        throw Failure(ExitCode::wrong_command, "--points: found one depth, wanted an interval such as --depth 0..50mm");
    if (arguments.points && (*arguments.points < 2 || *arguments.points > most_points)) {
        throw Failure(ExitCode::wrong_command, fmt::format("--points: found {}, wanted 2 to {}", *arguments.points, most_points));
    }
    if (!arguments.reference.empty() && question.varied)
        throw Failure(ExitCode::wrong_command, "--reference: found --vary, wanted one depth alone: a known load is of one scene");
    if (!arguments.reference.empty() && !one_depth) {
        throw Failure(
            ExitCode::wrong_command,
            "--reference: found no single depth, wanted one such as --depth '50 mm', or --depth '0 mm' of a needle in air");
    }
    question.points = arguments.points.value_or(question.points);
    return question;
}

/// Both pictures' names begin with this.
fs::path stem_of(const std::string& given) {
    const fs::path plot(given);
    const std::string ending = plot.extension();
    if (ending == ".svg" || ending == ".png") return fs::path(plot).replace_extension();
    const bool other_format = ending == ".pdf" || ending == ".eps" || ending == ".jpg" || ending == ".jpeg" || ending == ".gif";
    if (given != "-" && plot.has_filename() && !other_format) return plot;
    throw Failure(ExitCode::wrong_command,
                  fmt::format("--plot: found {}, wanted what both files' names begin with, such as out/insertion: it draws "
                              "STEM.svg and STEM.png",
                              core::quote(given)));
}

/// Where the answer goes besides the terminal; "-" is stdout.
struct Destinations {
    std::optional<std::string> json, csv;
    std::optional<fs::path> plot;

    [[nodiscard]] bool to_stdout() const { return json == "-" || csv == "-"; }
};

Destinations destinations(const LoadArguments& arguments) {
    Destinations to{.json = only("--json", arguments.json), .csv = only("--csv", arguments.csv), .plot = {}};
    if (const auto plot = only("--plot", arguments.plot)) to.plot = stem_of(*plot);
    if (to.json == "-" && to.csv == "-")
        throw Failure(ExitCode::wrong_command, "--csv: found '-' beside --json -, wanted a file for one of them: stdout is one");
    return to;
}

void expect_writable(const Destinations& to) {
    for (const auto& file : {to.json, to.csv}) {
        if (file && *file != "-") expect_writable_later(*file);
    }
    if (!to.plot) return;
    make_folder(to.plot->parent_path());
    for (const char* ending : {".svg", ".png"}) expect_writable_later(to.plot->string() + ending);
}

void deliver(const std::string& text, const std::optional<std::string>& file) {
    if (file == "-") {
        fmt::print("{}", text);
    } else if (file) {
        write_file(*file, text);
    }
}

ExitCode tell(const LoadArguments& arguments) {
    const LoadQuestion question = question_of(arguments);
    const Destinations to = destinations(arguments);
    const auto reference = only("--reference", arguments.reference);
    expect_writable(to);
    CriticalLoads loads = critical_loads(question);
    if (reference) add_references(*reference, loads);
    std::optional<Figure> figure;
    if (to.plot) figure = figure_of(loads);
    if (!to.to_stdout()) fmt::print("{}", loads_text(loads));
    deliver(loads_json(loads), to.json);
    deliver(loads_csv(loads), to.csv);
    if (!figure) return ExitCode::ok;
    const PictureFiles files = draw(*figure, *to.plot);
    fmt::print(to.to_stdout() ? stderr : stdout, "{}\n{}\n", files.svg.string(), files.png.string());
    return ExitCode::ok;
}

}    // namespace

Command critical_load_command(CLI::App& line) {
    const auto arguments = std::make_shared<LoadArguments>();
    CLI::App* options = line.add_subcommand("critical-load", "Tell at which force a needle buckles, by one model or several");
    options->footer(examples);
    arguments->scenes.add_to(*options);
    options->add_option("--model", arguments->models, "A model to ask, with parameters of its own; may be given several times")
        ->type_name("NAME[,KEY=VALUE]")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    const auto add_once = [&](const char* name, std::vector<std::string>& values, const char* type, const char* meaning) {
        options->add_option(name, values, meaning)
            ->type_name(type)
            ->expected(1)
            ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    };
    add_once("--depth", arguments->depth, "DEPTH", "Length of needle inserted: one, or an interval such as 0..50mm");
    add_once("--vary", arguments->vary, "KEY=FROM..TO", "A key of the scene, and the interval that it goes through");
    options->add_option("--points", arguments->points, "Of an interval; left out, 51. Borders of layers come on top")
        ->type_name("N");
    options->add_flag("--stiffness", arguments->stiffness,
                      "Also the spring constant that each load stands for by the paper's Eq. (3), of a needle wholly in tissue");
    add_once("--reference", arguments->reference, "FILE", "Known loads to compare with: a CSV `scene,load [N]`");
    add_once("--json", arguments->json, "FILE", "All of it as JSON; - for stdout, without the text");
    add_once("--csv", arguments->csv, "FILE", "All points as CSV; - for stdout, without the text");
    add_once("--plot", arguments->plot, "STEM", "Draw it with gnuplot, as STEM.svg and STEM.png");
    return {options, [arguments] { return tell(*arguments); }};
}

}    // namespace stylet::app
