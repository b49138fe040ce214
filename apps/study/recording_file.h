#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace stylet::study {

/// One column of a recording, in the unit that its header names (SI).
struct RecordedColumn {
    std::string name;
    std::string unit;    // empty where the header has none
    std::vector<double> values;
};

struct RecordedEvent {
    std::size_t row;
    std::string name;
};

/// A recording as a run wrote it: '#' lines, a header, rows; the last column names events, several joined by "; ".
struct Recording {
    std::filesystem::path file;
    std::string title;    // the file's stem where the recording has none
    std::vector<RecordedColumn> columns;
    std::vector<RecordedEvent> events;

    /// Throws Error with the columns there are where `name` is not one.
    [[nodiscard]] const RecordedColumn& column(const std::string& name) const;
};

/// Whether the file begins as recordings do.
[[nodiscard]] bool is_recording(const std::filesystem::path& file);

/// Throws Error with one sentence where the file is not a whole recording. A last line that a killed run cut off is left out.
[[nodiscard]] Recording read_recording(const std::filesystem::path& file);

}    // namespace stylet::study
