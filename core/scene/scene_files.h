// The files that a scene may read: those inside its own folder tree.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace stylet::core {

class SceneFiles {
public:
    /// The tree is the scene's folder or, where an ancestor folder is named `scenes`, the nearest such ancestor, so that prepared
    /// scenes share recorded hands and meshes.
    explicit SceneFiles(const std::filesystem::path& scene);

    /// What a scene's file name leads to.
    struct Found {
        std::filesystem::path file;    // full, symbolic links followed
        std::string problem;           // what was found instead ("'x.csv', which is not there"); empty where `file` holds
    };

    /// Relative to the scene's folder. A file that is found is kept in `named`.
    [[nodiscard]] Found find(const std::string& name);

    /// In the order of asking.
    [[nodiscard]] const std::vector<std::filesystem::path>& named() const { return named_; }

private:
    std::filesystem::path folder_;
    std::filesystem::path root_;
    std::vector<std::filesystem::path> named_;
};

/// A whole file's bytes; throws Error where it cannot be read or is longer than `longest` [bytes].
[[nodiscard]] std::string read_bytes(const std::filesystem::path& file, std::size_t longest);

}    // namespace stylet::core
