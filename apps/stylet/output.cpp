#include "apps/stylet/output.h"

#include "apps/stylet/failure.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <fstream>

namespace stylet::app {
namespace {

[[noreturn]] void cannot_write(const std::filesystem::path& file, int reason) {
    throw Failure(ExitCode::missing, fmt::format("{}: cannot be written: {}", file.string(), std::strerror(reason)));
}

}    // namespace

void make_folder(const std::filesystem::path& folder) {
    if (folder.empty()) return;
    std::error_code failed;
    std::filesystem::create_directories(folder, failed);
    if (failed)
        throw Failure(ExitCode::missing, fmt::format("{}: cannot be made a folder: {}", folder.string(), failed.message()));
    if (!std::filesystem::is_directory(folder)) {
        throw Failure(ExitCode::missing, fmt::format("{}: found a file, wanted a folder to write to", folder.string()));
    }
}

void expect_writable(const std::filesystem::path& file) {
    errno = 0;
    if (!std::ofstream(file, std::ios::app)) cannot_write(file, errno);
}

void expect_writable_later(const std::filesystem::path& file) {
    const bool was_there = std::filesystem::exists(file);
    expect_writable(file);
    if (!was_there) std::filesystem::remove(file);
}

void write_file(const std::filesystem::path& file, const std::string& text) {
    errno = 0;
    std::ofstream stream(file, std::ios::binary);
    stream << text;
    stream.close();
    if (!stream) cannot_write(file, errno);
}

}    // namespace stylet::app
