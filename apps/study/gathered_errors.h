#pragma once

#include "core/scene/reader.h"

#include <algorithm>
#include <string>
#include <vector>

namespace stylet::study {

/// Gathers errors, each once: what is wrong with a scene may be met more than once.
class GatheredErrors {
public:
    template <class Work>
    void gather(Work&& work) {
        try {
            work();
        } catch (const core::SceneErrors& errors) {
            for (const std::string& message : errors.messages()) {
                if (std::ranges::find(messages_, message) == messages_.end()) messages_.push_back(message);
            }
        }
    }
    /// With a `hint` after the last of them.
    void throw_if_any(const std::string& hint = "") const {
        if (messages_.empty()) return;
        std::vector<std::string> messages = messages_;
        messages.back() += hint;
        throw core::SceneErrors(messages);
    }

private:
    std::vector<std::string> messages_;
};

}    // namespace stylet::study
