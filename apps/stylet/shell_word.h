#pragma once

#include <string>

namespace stylet::app {

/// The text as one word of a shell's command: in quotes where it has to be.
[[nodiscard]] std::string shell_word(const std::string& text);

}    // namespace stylet::app
