#include "pose_file.h"

#include <array>
#include <charconv>
#include <cmath>
#include <fstream>

namespace stylet::recorded_hand {
namespace {

constexpr std::string_view header = "time [s],x [m],y [m],z [m],qw,qx,qy,qz";
constexpr std::size_t columns = 8;
constexpr double unit_tolerance = 1e-3;    // a quaternion written with four digits is still one

[[noreturn]] void refuse(int line, const std::string& message) {
    throw Error("file", "line " + std::to_string(line) + ": " + message);
}

/// The file's own words as a sentence shows them.
std::string quoted(std::string_view words) {
    constexpr std::size_t longest = 60;    // [bytes] a file that is no recording may have a line of any length
    std::string shown = "\"";
    shown += words.substr(0, longest);
    return shown += words.size() > longest ? "…\"" : "\"";
}

double read_number(std::string_view cell, int line) {
    while (!cell.empty() && cell.front() == ' ') cell.remove_prefix(1);
    while (!cell.empty() && cell.back() == ' ') cell.remove_suffix(1);
    double value = 0.0;
    const auto [end, problem] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
    if (problem != std::errc() || end != cell.data() + cell.size() || !std::isfinite(value)) {
        refuse(line, "found " + quoted(cell) + ", wanted a finite number");
    }
    return value;
}

std::array<double, columns> read_row(std::string_view text, int line) {
    std::array<double, columns> row{};
    std::size_t count = 0;
    for (std::size_t begin = 0; begin <= text.size(); ++count) {
        const std::size_t end = std::min(text.find(',', begin), text.size());
        if (count < columns) row[count] = read_number(text.substr(begin, end - begin), line);
        begin = end + 1;
    }
    if (count != columns) refuse(line, "found " + std::to_string(count) + " columns, wanted the 8 of the header");
    return row;
}

PoseKey key_of(const std::array<double, columns>& row, int line) {
    Quaternion rotation(row[4], row[5], row[6], row[7]);
    const double norm = rotation.norm();
    if (!(std::abs(norm - 1.0) <= unit_tolerance)) {
        refuse(line, "found a quaternion of length " + std::to_string(norm) + ", wanted one of length 1");
    }
    rotation.normalize();
    return {row[0], {Vector3(row[1], row[2], row[3]), rotation}};
}

}    // namespace

std::vector<PoseKey> read_pose_file(const std::string& path) {
    std::ifstream stream(path);
    if (!stream) throw Error("file", "cannot read \"" + path + "\"");
    std::string text;
    int line = 0;
    const auto next_line = [&] {
        ++line;
        text.clear();
        if (!std::getline(stream, text)) return false;
        if (text.ends_with('\r')) text.pop_back();
        return true;
    };
    while (next_line() && text.starts_with('#')) {
    }
    if (text != header) {
        refuse(line,
               "found " + (text.empty() ? "nothing" : quoted(text)) + ", wanted the header \"" + std::string(header) + "\"");
    }
    std::vector<PoseKey> keys;
    while (next_line()) {
        if (text.empty()) refuse(line, "found an empty line, wanted a pose");
        const PoseKey key = key_of(read_row(text, line), line);
        if (key.time < 0.0) refuse(line, "found a negative time, wanted times from 0 on");
        if (!keys.empty() && key.time <= keys.back().time) {
            refuse(line, "found a time that is not after the line before, wanted times that rise");
        }
        keys.push_back(key);
    }
    if (keys.empty()) refuse(line, "found no pose, wanted at least one");
    return keys;
}

}    // namespace stylet::recorded_hand
