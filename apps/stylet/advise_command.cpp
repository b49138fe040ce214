#include "apps/study/adviser.h"
#include "apps/stylet/advice_text.h"
#include "apps/stylet/command.h"
#include "apps/stylet/failure.h"
#include "apps/stylet/interrupt.h"
#include "apps/stylet/output.h"
#include "apps/stylet/scene_arguments.h"
#include "apps/stylet/study_progress.h"
#include "core/scene/complaints.h"
#include "core/scene/units.h"
#include "core/workers/worker_pool.h"

#include <fmt/format.h>

#include <charconv>
#include <memory>

namespace stylet::app {
namespace {

constexpr const char* examples =
    R"(Runs a scene and its neighbours, and says which setting to take: the most accurate whose ticks keep within the budget, and the
cheapest under the error. Neighbours are every combination of the models that the scene holds maps for, or that need no parameters,
and each parameter of the scene that buys accuracy with time, one step coarser and one step finer. Another rate is shown, and never
taken: it is the hand's; nor is a setting that gains less than a tenth. The error is that of the hand's force over time (of a tissue
alone, how far its loaded patches move; of a needle that nobody holds, how far it bows) against a reference: left out, the scene's
own models, or those that take twice as long or more, with all numbers but the rate one step finer. Beneath: what each effect of the
setting costs a tick, in the mean over the run, and what it changes, found by leaving it out. Given up, and told of, is a run that
would take more than 15 s; the scene itself and a reference that was looked for, 45 s. Times are only as good as the machine is
quiet.

Examples:
  stylet advise scenes/paper/fig10a_l150.yaml
  stylet advise scenes/paper/fig10a_l150.yaml --budget '0.5 ms' --error 1%
  stylet advise scenes/paper/fig9.yaml --reference needle.type=rod --reference tissue.type=corotational_fem
  stylet advise scenes/liver/bovine_liver.yaml --set 'run.rate=500 Hz' --json -

Exit codes: 0 ok, 2 the scene or the reference is wrong, 3 wrong command line, 4 a file cannot be written, 130 stopped by Ctrl-C,
which leaves files as they were.)";

struct AdviceArguments {
    SceneArguments scene;
    std::string budget, error = "5%";
    std::vector<std::string> reference;
    std::string json;
    int threads = core::processors();
};

double budget_of(const std::string& text) {
    const core::Quantity budget = core::read_quantity(text, "s");
    if (budget.problem.empty() && budget.value > 0.0) return budget.value;
    const std::string found = budget.problem.empty() ? core::quote(text) : budget.problem;
    throw Failure(ExitCode::wrong_command,
                  fmt::format("--budget: found {}, wanted a time for a tick, above 0, such as '1 ms'", found));
}

/// "5%", "5 %" or "0.05".
double error_of(const std::string& text) {
    double value = 0.0;
    const char* const end = text.data() + text.size();
    const auto [stop, problem] = std::from_chars(text.data(), end, value);
    const std::string rest(stop, end);
    const bool per_cent = rest == "%" || rest == " %";
    const double error = per_cent ? value / 100.0 : value;
    if (problem == std::errc{} && (per_cent || rest.empty()) && error > 0.0 && error < 1.0) return error;
    throw Failure(ExitCode::wrong_command,
                  fmt::format("--error: found {}, wanted a share between 0 and 1 such as 5% or 0.05", core::quote(text)));
}

std::vector<core::Override> reference_of(const std::vector<std::string>& texts) {
    std::vector<core::Override> changes;
    for (const std::string& text : texts) {
        const auto change = read_key_value(text);
        if (!change) {
            throw Failure(
                ExitCode::wrong_command,
                fmt::format("--reference: found {}, wanted KEY=VALUE, for instance needle.type=rod", core::quote(text)));
        }
        changes.push_back({.key = change->key, .value = change->value, .given = "--reference " + core::printable(change->key)});
    }
    return changes;
}

study::Request request_of(const AdviceArguments& arguments) {
    study::Request request{.scene = arguments.scene.files().front(),
                           .changes = arguments.scene.overrides(),
                           .budget = {},
                           .error = error_of(arguments.error),
                           .reference = {},
                           .threads = arguments.threads,
                           .folders = arguments.scene.folders()};
    if (!arguments.budget.empty()) request.budget = budget_of(arguments.budget);
    if (!arguments.reference.empty()) request.reference = reference_of(arguments.reference);
    return request;
}

std::optional<study::Advice> advice_on(const study::Request& request) {
    StudyProgress bar(request.scene.string());
    try {
        return study::advise(request, Interrupt::asked(), [&](const study::Progress& progress) { bar.show(progress); });
    } catch (const Error& error) {
        throw Failure(ExitCode::wrong_input, fmt::format("{}: {}", request.scene.string(), error.what()));
    }
}

ExitCode tell(const AdviceArguments& arguments) {
    const study::Request request = request_of(arguments);
    const bool to_stdout = arguments.json == "-";
    const bool to_file = !arguments.json.empty() && !to_stdout;
    if (to_file) expect_writable_later(arguments.json);
    const Interrupt interrupt;
    const std::optional<study::Advice> advice = advice_on(request);
    if (!advice) {
        fmt::print(stderr, "{}: stopped by Ctrl-C; nothing is written\n", request.scene.string());
        return ExitCode::interrupted;
    }
    fmt::print("{}", to_stdout ? advice_json(*advice) : advice_text(*advice));
    if (to_file) write_file(arguments.json, advice_json(*advice));
    return ExitCode::ok;
}

}    // namespace

Command advise_command(CLI::App& line) {
    const auto arguments = std::make_shared<AdviceArguments>();
    CLI::App* options =
        line.add_subcommand("advise", "Say which models and resolution to take for a scene, and what effects cost");
    options->footer(examples);
    arguments->scene.add_to(*options);
    options->get_option("SCENE")->expected(1);
    options->add_option("--budget", arguments->budget, "Time for a tick; left out, the scene's own period")->type_name("TIME");
    options->add_option("--error", arguments->error, "How far off a setting may be")->type_name("SHARE")->capture_default_str();
    options
        ->add_option("--reference", arguments->reference,
                     "Compare with the scene so changed, instead of with what is found; may be given several times")
        ->type_name("KEY=VALUE")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    options
        ->add_option("--threads", arguments->threads, "That models may share their work among; left out, one for each processor")
        ->type_name("N")
        ->check(CLI::Range(1, 256));
    options->add_option("--json", arguments->json, "All of it as JSON; - for stdout, without the text")->type_name("FILE");
    return {options, [arguments] { return tell(*arguments); }};
}

}    // namespace stylet::app
