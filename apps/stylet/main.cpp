// stylet: the command line. See `stylet --help`.
#include "apps/stylet/command.h"
#include "apps/stylet/failure.h"
#include "core/scene/reader.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <cstdio>
#include <new>
#include <system_error>

namespace stylet::app {
namespace {

constexpr const char* about =
    "Stylet pushes a flexible needle into soft tissue. A YAML scene says which tissue, needle, forces and hand.\n";

constexpr const char* more =
    R"(First steps:
  stylet scenes                               the prepared scenes
  stylet run scenes/paper/fig10a_l150.yaml    simulate one; its recording goes to out/
  stylet plot out/fig10a_l150.csv             draw force against depth
  stylet critical-load scenes/paper/fig9.yaml tell at which force its needle buckles
  stylet study scenes/studies/time_step.yaml  tell what accuracy costs in time
  stylet advise scenes/paper/fig9.yaml        tell which models and resolution to take for it
  stylet plugins                              the models that a scene can name

Exit codes:
  0  all is well
  1  a run ended with a fault
  2  a scene, a plugin or a recording is wrong or not there
  3  the command line makes no sense
  4  something is missing: a file cannot be written, gnuplot is not there
  130  stopped by Ctrl-C; what was done until then is kept

`stylet COMMAND --help` tells more about each command.)";

int complain(const std::string& message, ExitCode code) {
    fmt::print(stderr, "{}\n", message);
    return static_cast<int>(code);
}

int execute(const Command& command) {
    try {
        return static_cast<int>(command.execute());
    } catch (const core::SceneErrors& errors) {
        return complain(fmt::format("{}", fmt::join(errors.messages(), "\n")), ExitCode::wrong_input);
    } catch (const Failure& failure) {
        return complain(failure.what(), failure.code());
    } catch (const Error& error) {
        return complain(error.what(), ExitCode::wrong_input);
    } catch (const std::system_error& error) {    // a full disk under stdout, no thread left
        return complain(fmt::format("stylet: the system refuses: {}", error.what()), ExitCode::missing);
    } catch (const std::bad_alloc&) {
        return complain("stylet: this machine has not enough memory for that", ExitCode::missing);
    } catch (const std::exception& bug) {
        return complain(fmt::format("stylet: stopped by a mistake in stylet itself, please report it: {}", bug.what()),
                        ExitCode::missing);
    }
}

int main_of(int argc, char** argv) {
    CLI::App line{about, "stylet"};
    line.footer(more);
    line.set_version_flag("--version", "stylet " STYLET_VERSION, "Show the version");
    line.set_help_flag("-h,--help", "Show this help");
    line.require_subcommand(0, 1);
    const std::vector<Command> commands{run_command(line),           check_command(line), plugins_command(line),
                                        scenes_command(line),        plot_command(line),  schema_command(line),
                                        critical_load_command(line), study_command(line), advise_command(line)};
    try {
        line.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return line.exit(error) == 0 ? 0 : static_cast<int>(ExitCode::wrong_command);
    }
    for (const Command& command : commands) {
        if (!command.options->parsed()) continue;
        const int code = execute(command);
        if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return code;
        return complain("stylet: what was printed could not be written (is the disk full?)", ExitCode::missing);
    }
    return complain(
        "stylet: found no command, wanted run, check, plugins, scenes, plot, schema, critical-load, study or advise; "
        "stylet --help tells more",
        ExitCode::wrong_command);
}

}    // namespace
}    // namespace stylet::app

int main(int argc, char** argv) {
    return stylet::app::main_of(argc, argv);
}
