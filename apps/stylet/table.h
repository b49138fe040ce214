#pragma once

#include <string>
#include <vector>

namespace stylet::app {

/// Columns of text, each as wide as its widest cell.
class Table {
public:
    enum class Align { left, right };

    explicit Table(std::vector<Align> columns) : columns_(std::move(columns)) {}

    void add(std::vector<std::string> row) { rows_.push_back(std::move(row)); }
    [[nodiscard]] bool empty() const { return rows_.empty(); }

    /// One line per row, each begun with `indent` spaces and ended without blanks.
    [[nodiscard]] std::string text(std::size_t indent) const;

private:
    std::vector<Align> columns_;
    std::vector<std::vector<std::string>> rows_;
};

/// Characters that a terminal shows for this UTF-8 text.
[[nodiscard]] std::size_t width_of(const std::string& text);

/// Breaks `text` between words into lines of at most `width` characters, each begun with `indent` spaces.
[[nodiscard]] std::string wrapped(const std::string& text, std::size_t indent, std::size_t width);

}    // namespace stylet::app
