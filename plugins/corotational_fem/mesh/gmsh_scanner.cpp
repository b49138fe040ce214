#include "mesh/gmsh_scanner.h"

#include <algorithm>
#include <charconv>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace stylet::corotational_fem {
namespace {

constexpr std::uintmax_t most_bytes = 1U << 30U;    // some ten million tetrahedra: far more than any tick could move

bool is_blank(char c) {
    return c == ' ' || c == '\n' || c == '\r' || c == '\t';
}

}    // namespace

std::string in_quotes(std::string_view words) {
    constexpr std::size_t longest = 60;    // [bytes] a file that is no mesh may have a line of any length
    std::string shown = "\"";
    for (const char c : words.substr(0, longest)) shown += static_cast<unsigned char>(c) < ' ' ? '?' : c;
    return shown += words.size() > longest ? "…\"" : "\"";
}

GmshScanner::GmshScanner(const std::string& path) : path_(path) {
    std::error_code problem;
    if (!std::filesystem::is_regular_file(path, problem))
        throw complaint_of_file("found no file here, wanted a Gmsh mesh (.msh)");
    const std::uintmax_t size = std::filesystem::file_size(path, problem);
    if (problem || size > most_bytes) {
        throw complaint_of_file("found " + std::to_string(size) + " bytes, wanted at most " + std::to_string(most_bytes));
    }
    std::ifstream stream(path, std::ios::binary);
    text_.resize(size);
    stream.read(text_.data(), static_cast<std::streamsize>(size));
    if (!stream) throw complaint_of_file("this file cannot be read");
}

void GmshScanner::skip_blanks() {
    while (next_ < text_.size() && is_blank(text_[next_])) ++next_;
}

bool GmshScanner::at_end() {
    skip_blanks();
    return next_ == text_.size();
}

std::string_view GmshScanner::word(std::string_view wanted) {
    const bool ended = at_end();
    place_ = next_;
    if (ended) throw complaint("found the end of the file, wanted " + std::string(wanted));
    while (next_ < text_.size() && !is_blank(text_[next_])) ++next_;
    return std::string_view(text_).substr(place_, next_ - place_);
}

std::string GmshScanner::quoted(std::string_view wanted) {
    const std::string_view found = word(wanted);
    const std::size_t line_end = std::min(text_.find('\n', place_), text_.size());
    const std::size_t end = text_.find('"', place_ + 1);
    if (found.front() != '"' || end >= line_end) throw complaint("found " + in_quotes(found) + ", wanted " + std::string(wanted));
    next_ = end + 1;
    return text_.substr(place_ + 1, end - place_ - 1);
}

template <typename Number>
Number GmshScanner::text_value(std::string_view wanted) {
    const std::string_view found = word(wanted);
    Number value{};
    const auto [end, problem] = std::from_chars(found.data(), found.data() + found.size(), value);
    if (problem != std::errc() || end != found.data() + found.size()) {
        throw complaint("found " + in_quotes(found) + ", wanted " + std::string(wanted));
    }
    return value;
}

template <typename Number>
Number GmshScanner::value(std::string_view wanted) {
    if (!binary_) return text_value<Number>(wanted);
    place_ = next_;
    if (text_.size() - next_ < sizeof(Number)) throw complaint("found the end of the file, wanted " + std::string(wanted));
    Number value{};
    std::memcpy(&value, text_.data() + next_, sizeof value);
    next_ += sizeof value;
    return value;
}

template int GmshScanner::text_value(std::string_view);
template std::uint64_t GmshScanner::text_value(std::string_view);
template double GmshScanner::text_value(std::string_view);
template int GmshScanner::value(std::string_view);
template std::uint64_t GmshScanner::value(std::string_view);
template double GmshScanner::value(std::string_view);

void GmshScanner::refuse_beyond_file(std::uint64_t items, std::size_t values, const std::string& what) const {
    const std::size_t bytes = values * (binary_ ? sizeof(int) : 2);    // a digit and a blank at least
    const std::uint64_t most = (text_.size() - next_) / bytes + 1;
    if (items <= most) return;
    throw complaint("found a count of " + std::to_string(items) + " " + what +
                    ", wanted no more than the rest of the file can hold, " + std::to_string(most));
}

void GmshScanner::begin_values() {
    if (!binary_) return;
    place_ = next_;
    if (next_ < text_.size() && text_[next_] == '\r') ++next_;
    if (next_ == text_.size() || text_[next_] != '\n') throw complaint("wanted the end of this line, and binary values after it");
    ++next_;
}

void GmshScanner::expect(std::string_view wanted) {
    const std::string_view found = word(wanted);
    if (found != wanted) throw complaint("found " + in_quotes(found) + ", wanted " + std::string(wanted));
}

void GmshScanner::skip_past(std::string_view word) {
    const std::size_t found = text_.find(word, next_);
    if (found == std::string::npos) throw complaint("found the end of the file after this, wanted " + std::string(word));
    next_ = found + word.size();
}

Error GmshScanner::complaint(std::size_t place, const std::string& message) const {
    const auto line = 1 + std::count(text_.begin(), text_.begin() + static_cast<std::ptrdiff_t>(place), '\n');
    const std::string where = binary_ ? " byte " + std::to_string(place) : std::to_string(line);
    return {"mesh", path_ + ':' + where + ": " + message};
}

}    // namespace stylet::corotational_fem
