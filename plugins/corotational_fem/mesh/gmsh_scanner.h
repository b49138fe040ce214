#pragma once

#include <stylet/error.h>

#include <cstdint>
#include <string>
#include <string_view>

namespace stylet::corotational_fem {

/// Reads the words and values of a Gmsh file one after another, text or binary, and refuses what it can't with Error at `mesh`:
/// `file:line: found …, wanted …` (of a binary file, its byte in place of its line). `wanted` always says what is wanted in
/// words.
class GmshScanner {
public:
    /// Reads the whole file. Refuses what is no file, and one beyond a gigabyte.
    explicit GmshScanner(const std::string& path);

    void set_binary() { binary_ = true; }
    [[nodiscard]] bool binary() const { return binary_; }

    /// The next word of text; never empty.
    [[nodiscard]] std::string_view word(std::string_view wanted);
    /// The next text between quotation marks, on one line.
    [[nodiscard]] std::string quoted(std::string_view wanted);
    /// The next value, written as text. Number: int, std::uint64_t or double.
    template <typename Number>
    [[nodiscard]] Number text_value(std::string_view wanted);
    /// The next value in the file's form.
    template <typename Number>
    [[nodiscard]] Number value(std::string_view wanted);

    /// Refuses a number of items that the rest of the file can't hold, when each takes `values` values or more.
    void refuse_beyond_file(std::uint64_t items, std::size_t values, const std::string& what) const;
    /// Steps over the end of a line of text, to where binary values begin.
    void begin_values();
    /// Refuses any other word.
    void expect(std::string_view wanted);
    void skip_past(std::string_view word);
    /// Only blanks are left.
    [[nodiscard]] bool at_end();

    /// Where the latest word or value began.
    [[nodiscard]] std::size_t place() const { return place_; }
    [[nodiscard]] Error complaint(std::size_t place, const std::string& message) const;
    [[nodiscard]] Error complaint(const std::string& message) const { return complaint(place_, message); }
    /// Of the file as a whole.
    [[nodiscard]] Error complaint_of_file(const std::string& message) const { return {"mesh", path_ + ": " + message}; }

private:
    void skip_blanks();

    std::string path_;
    std::string text_;
    std::size_t next_ = 0;
    std::size_t place_ = 0;
    bool binary_ = false;
};

/// A file's own words as a sentence shows them.
[[nodiscard]] std::string in_quotes(std::string_view words);

}    // namespace stylet::corotational_fem
