// What a study has measured so far, so that it goes on where it was stopped.
#pragma once

#include "apps/study/file_lock.h"
#include "apps/study/outcome.h"

#include <filesystem>
#include <fstream>
#include <map>
#include <mutex>
#include <string>

namespace stylet::study {

/// A file with a line of JSON for each outcome, written as soon as there is one. Lines that cannot be read, such as one cut by a
/// kill, are as if they were not there.
class RunLog {
public:
    /// Without a file nothing is kept; what it has may be forgotten. Throws Error where another study is at it, std::system_error
    /// where it cannot be written.
    RunLog(const std::filesystem::path& file, bool forget);

    /// nullptr where it has none, or one that was timed while the machine had other work: it may be quiet now.
    [[nodiscard]] const Outcome* find(const std::string& key) const;

    /// May be called from several threads. Throws std::system_error where the disk is full.
    void add(const std::string& key, const std::string& name, const Outcome& outcome);

private:
    bool read_earlier();    // whether its last line ends

    std::filesystem::path file_;
    FileLock lock_;
    std::map<std::string, Outcome> known_;
    std::ofstream stream_;
    std::mutex mutex_;
};

}    // namespace stylet::study
