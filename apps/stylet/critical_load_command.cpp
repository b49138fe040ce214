#include "apps/stylet/command.h"
#include "apps/stylet/critical_loads.h"
#include "apps/stylet/failure.h"
#include "apps/stylet/gnuplot.h"
#include "apps/stylet/load_figure.h"
#include "apps/stylet/load_text.h"
#include "apps/stylet/output.h"
#include "apps/stylet/reference_loads.h"
#include "apps/stylet/scene_arguments.h"
#include "core/scene/complaints.h"
#include "core/scene/units.h"

#include <fmt/format.h>

#include <memory>
#include <set>

namespace stylet::app {
namespace {

namespace fs = std::filesystem;

constexpr const char* examples =
    R"(Tells at which force the needle buckles, by each named model, while it goes in at a right angle: from the tip on the surface to
all of it inside, or at one depth. Beneath the table: whether it buckles before the tip punctures, if the scene's effects say at
which force that is, and from which depth on it bears more.
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

struct LoadArguments {
    SceneArguments scenes;
    std::vector<std::string> models;
    std::string depth;
    std::string vary;
    std::optional<int> points;
    bool stiffness = false;
    std::string reference;
    std::string json, csv, plot;
};

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

Interval depth_of(const std::string& text) {
    Interval depth = read_interval("--depth", text);
    const core::Quantity quantity = core::read_quantity(depth.quantity(depth.to), "m");
    if (quantity.problem.empty()) return depth;
    throw Failure(ExitCode::wrong_command, fmt::format("--depth: found {}, wanted {}, or an interval such as 0..50mm",
                                                       quantity.problem, core::wanted_quantity("m")));
}

LoadQuestion question_of(const LoadArguments& arguments) {
    LoadQuestion question{.scenes = arguments.scenes.files(),
                          .overrides = arguments.scenes.overrides(),
                          .folders = arguments.scenes.folders(),
                          .models = asked_models(arguments.models),
                          .depth = {},
                          .varied = {},
                          .stiffness = arguments.stiffness};
    if (!arguments.depth.empty()) question.depth = depth_of(arguments.depth);
    if (!arguments.vary.empty()) question.varied = varied_key(arguments.vary);
    if (question.varied && question.depth && !question.depth->one_value()) {
        throw Failure(ExitCode::wrong_command,
                      fmt::format("--depth: found {} beside --vary, wanted one depth: a picture has one axis",
                                  core::quote(arguments.depth)));
    }
    const bool one_depth = !question.varied && question.depth && question.depth->one_value();
    if (arguments.points && one_depth)
        throw Failure(ExitCode::wrong_command, "--points: found one depth, wanted an interval such as --depth 0..50mm");
    if (!arguments.reference.empty() && !one_depth)
        throw Failure(ExitCode::wrong_command, "--reference: found no single depth, wanted one such as --depth '50 mm'");
    question.points = arguments.points.value_or(question.points);
    return question;
}

/// Both pictures' names begin with this.
fs::path stem_of(const fs::path& plot) {
    return plot.extension() == ".svg" || plot.extension() == ".png" ? fs::path(plot).replace_extension() : plot;
}

void deliver(const std::string& text, const std::string& file) {
    if (file == "-") {
        fmt::print("{}", text);
    } else if (!file.empty()) {
        write_file(file, text);
    }
}

ExitCode tell(const LoadArguments& arguments) {
    CriticalLoads loads = critical_loads(question_of(arguments));
    if (!arguments.reference.empty()) add_references(arguments.reference, loads);
    std::optional<Figure> figure;
    if (!arguments.plot.empty()) figure = figure_of(loads);
    if (arguments.json != "-" && arguments.csv != "-") fmt::print("{}", loads_text(loads));
    deliver(loads_json(loads), arguments.json);
    deliver(loads_csv(loads), arguments.csv);
    if (!figure) return ExitCode::ok;
    const PictureFiles files = draw(*figure, stem_of(arguments.plot));
    fmt::print(arguments.json == "-" || arguments.csv == "-" ? stderr : stdout, "{}\n{}\n", files.svg.string(),
               files.png.string());
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
    options->add_option("--depth", arguments->depth, "Of the tip: one, or an interval such as 0..50mm")->type_name("DEPTH");
    options->add_option("--vary", arguments->vary, "A key of the scene, and the interval that it goes through")
        ->type_name("KEY=FROM..TO");
    options->add_option("--points", arguments->points, "Of an interval; left out, 51")
        ->type_name("N")
        ->check(CLI::Range(2, 10000));
    options->add_flag("--stiffness", arguments->stiffness,
                      "Also the spring constant that each load stands for by the paper's Eq. (3), of a needle wholly in tissue");
    options->add_option("--reference", arguments->reference, "Known loads to compare with: a CSV `scene,load [N]`")
        ->type_name("FILE");
    options->add_option("--json", arguments->json, "All of it as JSON; - for stdout, without the text")->type_name("FILE");
    options->add_option("--csv", arguments->csv, "All points as CSV; - for stdout, without the text")->type_name("FILE");
    options->add_option("--plot", arguments->plot, "Draw it with gnuplot, as STEM.svg and STEM.png")->type_name("STEM");
    return {options, [arguments] { return tell(*arguments); }};
}

}    // namespace stylet::app
