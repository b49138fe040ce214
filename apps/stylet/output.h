// Where commands leave their files: whatever goes wrong there is one sentence and ExitCode::missing.
#pragma once

#include <filesystem>
#include <string>

namespace stylet::app {

void make_folder(const std::filesystem::path& folder);

/// Throws where `file` cannot be written, so that a long run does not end in vain; leaves what is there alone.
void expect_writable(const std::filesystem::path& file);

/// The same, and leaves nothing behind: of a file that is only written where all goes well.
void expect_writable_later(const std::filesystem::path& file);

void write_file(const std::filesystem::path& file, const std::string& text);

}    // namespace stylet::app
