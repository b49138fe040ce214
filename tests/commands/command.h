// Runs `stylet` as a user would: a process in a folder of its own.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace stylet::commands {

inline const std::filesystem::path scene_folder = SCENE_FOLDER;

/// A paper scene's path.
[[nodiscard]] inline std::string paper(const std::string& name) {
    return (scene_folder / "paper" / (name + ".yaml")).string();
}

struct Outcome {
    int code;
    std::string out;
    std::string err;
};

/// A folder of one test's own to run commands in; gone with the test.
class Bench {
public:
    Bench();
    Bench(const Bench&) = delete;
    Bench& operator=(const Bench&) = delete;
    ~Bench();

    /// Runs `stylet` with these arguments in the folder.
    [[nodiscard]] Outcome stylet(const std::vector<std::string>& arguments) const;

    /// The same where `folder` is all there is on the PATH.
    [[nodiscard]] Outcome stylet_with_path(const std::string& folder, const std::vector<std::string>& arguments) const;

    [[nodiscard]] std::filesystem::path path(const std::string& name) const { return folder_ / name; }
    [[nodiscard]] bool has(const std::string& name) const { return std::filesystem::exists(path(name)); }
    void write(const std::string& name, const std::string& text) const;
    [[nodiscard]] std::string read(const std::string& name) const;

private:
    std::filesystem::path folder_;
};

}    // namespace stylet::commands
