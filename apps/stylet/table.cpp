#include "apps/stylet/table.h"

#include <algorithm>
#include <sstream>

namespace stylet::app {

std::size_t width_of(const std::string& text) {
    // Every byte but UTF-8's continuation bytes begins a character.
    return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char byte) { return (byte & 0xC0) != 0x80; }));
}

std::string Table::text(std::size_t indent) const {
    std::vector<std::size_t> widths(columns_.size(), 0);
    for (const auto& row : rows_) {
        for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], width_of(row[i]));
    }
    std::string lines;
    for (const auto& row : rows_) {
        std::string line(indent, ' ');
        for (std::size_t i = 0; i < row.size(); ++i) {
            const std::string padding(widths[i] - width_of(row[i]), ' ');
            line += columns_[i] == Align::left ? row[i] + padding : padding + row[i];
            line += "   ";
        }
        line.erase(line.find_last_not_of(' ') + 1);
        lines += line + "\n";
    }
    return lines;
}

std::string wrapped(const std::string& text, std::size_t indent, std::size_t width) {
    std::istringstream words(text);
    std::string lines, line, word;
    const std::string margin(indent, ' ');
    while (words >> word) {
        if (!line.empty() && indent + width_of(line) + 1 + width_of(word) > width) {
            lines += margin + line + "\n";
            line.clear();
        }
        line += line.empty() ? word : " " + word;
    }
    return line.empty() ? lines : lines + margin + line + "\n";
}

}    // namespace stylet::app
