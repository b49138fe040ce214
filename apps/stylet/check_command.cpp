#include "apps/study/known_answers.h"
#include "apps/study/study_reader.h"
#include "apps/stylet/command.h"
#include "apps/stylet/scene_arguments.h"
#include "core/loading/cast.h"

#include <fmt/format.h>

#include <memory>

namespace stylet::app {
namespace {

constexpr const char* examples =
    R"(Shows all errors of each scene at once, as file:line:col: path: what was found, what was wanted. Of a study, with those of every
scene that it makes.

Examples:
  stylet check scenes/paper/fig9.yaml
  stylet check scenes/*/*.yaml
  stylet check scenes/studies/time_step.yaml
  stylet check scenes/paper/fig9.yaml --set needle.type=rigid

Exit codes: 0 all scenes are sound, 2 one is not, 3 wrong command line.)";

/// Reads every scene that it makes, and its files of known answers.
void check_study(const std::string& file, const core::PluginFolders& folders) {
    const study::Study study = study::read_study(file, folders);
    const study::Plan plan = study::plan_of(study, folders, "");
    const study::KnownAnswers known(study, plan);
}

/// Sound means of a scene that its models can be made too, so the cast is loaded and let go again.
bool sound(const std::string& file, const std::vector<core::Override>& overrides, const core::PluginFolders& folders) {
    try {
        if (overrides.empty() && core::holds_study(file)) {
            check_study(file, folders);
        } else {
            const core::Cast cast(core::read_scene(file, overrides, folders), folders);
        }
    } catch (const core::SceneErrors& errors) {
        fmt::print(stderr, "{}\n", fmt::join(errors.messages(), "\n"));
        return false;
    } catch (const Error& error) {    // of a file of known answers
        fmt::print(stderr, "{}\n", error.what());
        return false;
    }
    fmt::print("{}: sound\n", file);
    return true;
}

}    // namespace

Command check_command(CLI::App& line) {
    const auto arguments = std::make_shared<SceneArguments>();
    CLI::App* options = line.add_subcommand("check", "Tell all that is wrong with scenes, without running them");
    options->footer(examples);
    arguments->add_to(*options);
    return {options, [arguments] {
                const std::vector<core::Override> overrides = arguments->overrides();
                const core::PluginFolders folders = arguments->folders();
                bool all = true;
                for (const std::string& file : arguments->files()) all &= sound(file, overrides, folders);
                return all ? ExitCode::ok : ExitCode::wrong_input;
            }};
}

}    // namespace stylet::app
