#pragma once

#include "core/run/sample.h"
#include "core/run/simulation.h"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace stylet::core {

/// Writes a run as CSV while it goes: `#` lines of title, scene and hash, a row of names with units, one row for each tick, whose
/// last column names the tick's events. A thread of its own drains a ring and writes twenty times a second, so a killed run
/// keeps all but its last tenth of a second and the tick makes no system call. Whole rows go to each write(2): a killed run ends
/// with a whole one, unless it dies within those microseconds and the system stops between two pages of the file; readers leave
/// out a last line without its line feed.
class Recorder {
public:
    struct Heading {
        std::string title, scene, hash;
    };

    /// Throws Error where the file cannot be written.
    Recorder(const std::filesystem::path& file, const Heading& heading, std::vector<Column> columns);

    /// Writes what is left. Errors of the last writes are lost here: call finish() to hear of them.
    ~Recorder();

    /// From the tick; false where the ring is full: the caller then waits between two ticks. Neither allocates nor locks.
    [[nodiscard]] bool push(const Sample& sample, std::span<const Event> events);

    /// Waits until everything is in the file. Throws Error where the disk was full.
    void finish();

    Recorder(const Recorder&) = delete;
    Recorder& operator=(const Recorder&) = delete;

private:
    class Writer;
    std::unique_ptr<Writer> writer_;
};

}    // namespace stylet::core
