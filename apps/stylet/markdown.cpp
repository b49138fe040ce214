#include "apps/stylet/markdown.h"

#include <string_view>

namespace stylet::app {

std::string markdown(const std::string& text) {
    constexpr std::string_view markup = "\\*<";
    std::string escaped;
    bool code = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i], next = i + 1 < text.size() ? text[i + 1] : ' ';
        const bool lone_backtick = c == '`' && !code && text.find('`', i + 1) == std::string::npos;
        const bool heading = i == 0 && c == '#';
        const bool link = c == ']' && next == '(';
        if (c == '`' && !lone_backtick) code = !code;
        if (!code && (markup.find(c) != std::string_view::npos || lone_backtick || heading || link)) escaped += '\\';
        escaped += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
    }
    return escaped;
}

std::string markdown_cell(const std::string& text) {
    std::string escaped;
    for (const char c : markdown(text)) {
        if (c == '|') escaped += '\\';
        escaped += c;
    }
    return escaped;
}

}    // namespace stylet::app
