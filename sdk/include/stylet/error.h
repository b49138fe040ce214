// The one error type. Thrown while loading only: nothing throws in a tick.
#pragma once

#include <stdexcept>
#include <string>
#include <utility>

namespace stylet {

/// What is wrong with a scene or a plugin. `key` is the parameter at fault (empty where none is); core finds its line in the
/// scene.
class Error : public std::runtime_error {
public:
    explicit Error(const std::string& message) : std::runtime_error(message) {}
    Error(std::string key, const std::string& message) : std::runtime_error(message), key_(std::move(key)) {}

    [[nodiscard]] const std::string& key() const noexcept { return key_; }

private:
    std::string key_;
};

}    // namespace stylet
