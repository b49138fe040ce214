// One file per command: it declares its options and returns what to do when the user named it.
#pragma once

#include "apps/stylet/exit_code.h"

#include <CLI/App.hpp>

#include <functional>

namespace stylet::app {

struct Command {
    CLI::App* options;                    // owned by the whole command line
    std::function<ExitCode()> execute;    // throws Failure or core::SceneErrors
};

Command run_command(CLI::App& line);
Command check_command(CLI::App& line);
Command plugins_command(CLI::App& line);
Command scenes_command(CLI::App& line);
Command plot_command(CLI::App& line);
Command schema_command(CLI::App& line);
Command critical_load_command(CLI::App& line);
Command study_command(CLI::App& line);
Command advise_command(CLI::App& line);

}    // namespace stylet::app
