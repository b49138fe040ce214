#include "apps/stylet/markdown.h"

#include <string_view>

namespace stylet::app {

std::string markdown(const std::string& text) {
    constexpr std::string_view markup = "\\*<|";
    std::string escaped;
    bool code = false;
    for (const char c : text) {
        if (c == '`') code = !code;
        if (!code && markup.find(c) != std::string_view::npos) escaped += '\\';
        escaped += c;
    }
    return escaped;
}

}    // namespace stylet::app
