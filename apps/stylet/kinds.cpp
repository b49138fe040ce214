#include "apps/stylet/kinds.h"

#include <iterator>
#include <sstream>

namespace stylet::app {

const char* name_of(Kind kind) {
    switch (kind) {
        case Kind::number:
            return "number";
        case Kind::integer:
            return "whole number";
        case Kind::text:
            return "text";
        case Kind::choice:
            return "choice";
        case Kind::file:
            return "file";
        case Kind::vector3:
            return "[x, y, z]";
        case Kind::records:
            return "list of maps";
    }
    return "";
}

bool is_numeric(Kind kind) {
    return kind == Kind::number || kind == Kind::integer;
}

std::vector<std::string> words_of(const char* text) {
    std::istringstream stream(text);
    return {std::istream_iterator<std::string>(stream), {}};
}

}    // namespace stylet::app
