#include "apps/study/recording_file.h"

#include "core/scene/complaints.h"

#include <stylet/error.h>

#include <fmt/format.h>

#include <cerrno>
#include <charconv>
#include <cstring>
#include <fstream>
#include <string_view>

namespace stylet::study {
namespace {

constexpr std::string_view signature = "# stylet recording 1";

/// The lines of a file that were written to their end.
class WholeLines {
public:
    explicit WholeLines(const std::filesystem::path& file) : name_(file.string()) {
        errno = 0;
        stream_.open(file, std::ios::binary);
        if (!stream_) throw Error(fmt::format("{}: cannot be read: {}", name_, std::strerror(errno)));
    }

    bool next() {
        if (!std::getline(stream_, line_) || stream_.eof()) return false;    // no end of line: a killed run cut it off
        if (line_.ends_with('\r')) line_.pop_back();
        ++number_;
        return true;
    }

    [[nodiscard]] std::string_view text() const { return line_; }

    [[noreturn]] void fail(const std::string& sentence) const {
        throw Error(fmt::format("{}:{}: {}", name_, number_, core::printable(sentence)));
    }

private:
    std::string name_;
    std::ifstream stream_;
    std::string line_;
    int number_ = 0;
};

/// Takes what stands before the next `separator` off the front of `text`.
std::string_view take(std::string_view& text, std::string_view separator) {
    const std::size_t end = text.find(separator);
    const std::string_view front = text.substr(0, end);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + separator.size());
    return front;
}

/// Reads the '#' lines; leaves `lines` at the header.
void read_comments(WholeLines& lines, Recording& recording) {
    if (!lines.next()) throw Error(fmt::format("{}:1: found nothing, wanted \"{}\"", recording.file.string(), signature));
    if (lines.text() != signature) {
        lines.fail(fmt::format("found \"{}\", wanted \"{}\": this is no recording, or one of another version",
                               lines.text().substr(0, 60), signature));
    }
    while (lines.next()) {
        if (!lines.text().starts_with('#')) return;
        constexpr std::string_view title = "# title: ";
        if (lines.text().starts_with(title) && lines.text() != title) recording.title = lines.text().substr(title.size());
    }
    lines.fail("the recording ends before its header");
}

/// "depth [m]" → depth, m
RecordedColumn named_column(std::string_view cell) {
    RecordedColumn column;
    column.name = take(cell, " [");
    column.unit = take(cell, "]");
    return column;
}

void read_header(const WholeLines& lines, Recording& recording) {
    std::string_view text = lines.text();
    constexpr std::string_view last = ",event";
    if (!text.ends_with(last) || text == last)
        lines.fail(fmt::format("found the header \"{}\", wanted columns that end in \"event\"", text.substr(0, 60)));
    text.remove_suffix(last.size());
    while (!text.empty()) recording.columns.push_back(named_column(take(text, ",")));
}

void read_row(const WholeLines& lines, Recording& recording) {
    std::string_view text = lines.text();
    for (RecordedColumn& column : recording.columns) {
        if (text.empty())
            lines.fail(fmt::format("the row ends before its {}, wanted {} numbers", column.name.substr(0, 40),
                                   recording.columns.size()));
        const std::string_view cell = take(text, ",");
        double value = 0.0;
        const auto [end, failed] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
        if (failed != std::errc() || end != cell.data() + cell.size()) {
            lines.fail(fmt::format("{}: found \"{}\", wanted a number", column.name.substr(0, 40), cell.substr(0, 40)));
        }
        column.values.push_back(value);
    }
    const std::size_t row = recording.columns.front().values.size() - 1;
    while (!text.empty()) recording.events.push_back({row, std::string(take(text, "; "))});
}

}    // namespace

const RecordedColumn& Recording::column(const std::string& name) const {
    std::vector<std::string> names;
    for (const RecordedColumn& column : columns) {
        if (column.name == name) return column;
        names.push_back(column.name);
    }
    throw Error(
        fmt::format("{}: found no column \"{}\", wanted one of: {}", file.string(), name, core::printable(core::list_of(names))));
}

bool is_recording(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    std::string beginning(signature.size(), '\0');
    return stream.read(beginning.data(), static_cast<std::streamsize>(beginning.size())) && beginning == signature;
}

Recording read_recording(const std::filesystem::path& file) {
    if (std::filesystem::is_directory(file)) {
        throw Error(fmt::format("{}: found a folder, wanted a recording", file.string()));
    }
    Recording recording{.file = file, .title = file.stem().string(), .columns = {}, .events = {}};
    WholeLines lines(file);
    read_comments(lines, recording);
    read_header(lines, recording);
    while (lines.next()) read_row(lines, recording);
    if (recording.columns.front().values.empty()) lines.fail("the recording holds no whole row");
    return recording;
}

}    // namespace stylet::study
