#pragma once

#include "apps/stylet/exit_code.h"

#include <stdexcept>
#include <string>

namespace stylet::app {

/// Ends the command with this code after this sentence (or these lines).
class Failure : public std::runtime_error {
public:
    Failure(ExitCode code, const std::string& message) : std::runtime_error(message), code_(code) {}
    [[nodiscard]] ExitCode code() const { return code_; }

private:
    ExitCode code_;
};

}    // namespace stylet::app
