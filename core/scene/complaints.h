// All that is wrong with a scene, gathered until everything has been looked at.
#pragma once

#include "core/scene/scene.h"

#include <string>
#include <vector>

namespace stylet::core {

class Complaints {
public:
    /// `path` is the key at fault (tissue.layers[0].density), `sentence` what was found and what was wanted.
    void add(const Place& place, const std::string& path, const std::string& sentence);

    /// `file:line:col: path: sentence`, in the order of the lines; what a `--set` brought in comes last.
    [[nodiscard]] std::vector<std::string> messages() const;

    [[nodiscard]] bool any() const { return !complaints_.empty(); }

    /// Throws SceneErrors if there is anything to complain of.
    void throw_if_any() const;

private:
    struct Complaint {
        Place place;
        std::string path;
        std::string sentence;
    };
    std::vector<Complaint> complaints_;
};

/// A scene's own words as a sentence shows them: in single quotes, control characters escaped, long text cut short.
[[nodiscard]] std::string quote(const std::string& text);

/// Control characters escaped, so that a mangled scene cannot mangle the terminal.
[[nodiscard]] std::string printable(const std::string& text);

/// "a, b, c"
[[nodiscard]] std::string list_of(const std::vector<std::string>& words);

}    // namespace stylet::core
