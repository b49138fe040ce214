#pragma once

#include <filesystem>

namespace stylet::study {

/// Keeps a file for one holder at a time; the system lets go of it with the process, however that ends.
class FileLock {
public:
    /// Makes the file where there is none; without a name nothing is kept. Throws Error where another has it,
    /// std::system_error where it cannot be written.
    explicit FileLock(const std::filesystem::path& file);
    FileLock(const FileLock&) = delete;
    FileLock& operator=(const FileLock&) = delete;
    ~FileLock();

private:
    int descriptor_ = -1;
};

}    // namespace stylet::study
