#pragma once

#include <boost/uuid/detail/sha1.hpp>

#include <string>

namespace stylet::core {

/// SHA-1 of a list of texts.
class Sha1 {
public:
    void add(const std::string& bytes);
    [[nodiscard]] std::string hexadecimal();    // once, in the end

private:
    boost::uuids::detail::sha1 sha_;
};

}    // namespace stylet::core
