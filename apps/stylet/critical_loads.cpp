#include "apps/stylet/critical_loads.h"

#include "apps/stylet/failure.h"
#include "apps/stylet/scene_loads.h"
#include "core/scene/units.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

namespace stylet::app {
namespace {

namespace fs = std::filesystem;

/// The last `parts` parts of the path, without the file's ending.
std::string tail(const fs::path& path, std::size_t parts) {
    fs::path tail = path.stem(), folder = path.parent_path();
    for (std::size_t i = 1; i < parts && folder.has_filename(); ++i, folder = folder.parent_path())
        tail = folder.filename() / tail;
    return tail.string();
}

/// By what each file is told from the others: as little of its path as will do.
std::vector<std::string> names_of(const std::vector<std::string>& files) {
    std::vector<fs::path> paths;
    for (const std::string& file : files) {
        std::error_code failed;
        const fs::path path = fs::weakly_canonical(file, failed);
        paths.push_back(failed ? fs::path(file) : path);
        if (std::ranges::count(paths, paths.back()) > 1)
            throw Failure(ExitCode::wrong_command, fmt::format("{}: found this scene a second time, wanted each once", file));
    }
    std::vector<std::string> names;
    for (const fs::path& path : paths) {
        const auto ambiguous = [&](std::size_t parts) {
            return std::ranges::count(paths, tail(path, parts), [&](const fs::path& other) { return tail(other, parts); }) > 1;
        };
        const auto most = static_cast<std::size_t>(std::distance(path.begin(), path.end()));
        std::size_t parts = 1;
        while (parts < most && ambiguous(parts)) ++parts;
        names.push_back(tail(path, parts));
    }
    return names;
}

/// What is wrong with each scene. A sentence on an option names no scene: where it is not of all of them, its scene is named.
class ErrorsByScene {
public:
    template <class Work>
    void gather(const std::string& file, Work&& work) {
        ++scenes_;
        try {
            work();
        } catch (const core::SceneErrors& errors) {
            for (const std::string& message : errors.messages()) messages_.emplace_back(file, message);
        }
    }
    void throw_if_any() const {
        std::vector<std::string> told;
        for (const auto& [file, message] : messages_) {
            const bool of_all = std::ranges::count(messages_, message, &Message::second) == scenes_;
            const std::string shown = of_all || !message.starts_with("--") ? message : fmt::format("{}: {}", file, message);
            if (std::ranges::find(told, shown) == told.end()) told.push_back(shown);
        }
        if (!told.empty()) throw core::SceneErrors(told);
    }

private:
    using Message = std::pair<std::string, std::string>;    // file, sentence
    std::vector<Message> messages_;
    std::ptrdiff_t scenes_ = 0;
};

}    // namespace

const LoadCurve* SceneLoads::curve(const std::string& model) const {
    const auto found = std::ranges::find(curves, model, &LoadCurve::model);
    return found == curves.end() ? nullptr : &*found;
}

std::vector<std::string> CriticalLoads::models() const {
    std::vector<std::string> models;
    for (const SceneLoads& scene : scenes) {
        for (const LoadCurve& curve : scene.curves) {
            if (std::ranges::find(models, curve.model) == models.end()) models.push_back(curve.model);
        }
    }
    return models;
}

bool CriticalLoads::one_point() const {
    return std::ranges::all_of(scenes, [](const SceneLoads& scene) { return scene.points.size() == 1; });
}

CriticalLoads critical_loads(const LoadQuestion& question) {
    CriticalLoads loads{.axis = "inserted",
                        .unit = "mm",
                        .along_depth = !question.varied,
                        .whole = !question.varied && !question.depth,
                        .stiffness = question.stiffness,
                        .scenes = {}};
    if (question.varied) {
        loads.axis = question.varied->key;
        loads.unit = question.varied->values.unit;
        if (question.depth) loads.depth = core::read_quantity(question.depth->text, "m").value;
    } else if (question.depth) {
        loads.unit = question.depth->unit;
    }
    const std::vector<std::string> names = names_of(question.scenes);
    ErrorsByScene errors;
    for (std::size_t i = 0; i < names.size(); ++i) {
        errors.gather(question.scenes[i], [&] {
            loads.scenes.push_back(scene_loads(question, question.scenes[i]));
            loads.scenes.back().name = names[i];
        });
    }
    errors.throw_if_any();
    return loads;
}

}    // namespace stylet::app
