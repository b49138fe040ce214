#pragma once

namespace stylet::app {

/// What a script learns from `stylet`; the texts of `--help` say the same.
enum class ExitCode : int {
    ok = 0,
    fault = 1,            // a run ended with a fault
    wrong_input = 2,      // a scene, a plugin or a recording is wrong or not there
    wrong_command = 3,    // the command line makes no sense
    missing = 4,          // a file cannot be written, gnuplot is not there
    interrupted = 130     // Ctrl-C; what was done is kept
};

}    // namespace stylet::app
