// Any bytes as a scene, beside the real plugins: reading it and making its cast ends in a cast or in SceneErrors. Lines that
// begin with "--set " are no part of the scene but overrides of it.
#include "core/loading/cast.h"
#include "core/scene/reader.h"

#include "tests/fuzzing/input_file.h"

namespace stylet::core {
namespace {

namespace fs = std::filesystem;

/// The prepared scenes' folder tree, with the fuzzed scene in the midst of it, so that it can name recorded hands.
class SceneTree {
public:
    SceneTree() { fs::copy(SCENE_FOLDER, folder_.path() / "scenes", fs::copy_options::recursive); }

    [[nodiscard]] fs::path scene() const { return folder_.path() / "scenes/paper/fuzzed.yaml"; }

private:
    fuzzing::Folder folder_;
};

/// Keeps every library open: libFuzzer's counters live in them, and opening them anew would take most of the time.
std::vector<PluginLibrary> open_all(const PluginFolders& folders) {
    std::vector<PluginLibrary> libraries;
    for (const std::string& name : folders.names()) libraries.push_back(PluginLibrary::open(name, folders));
    return libraries;
}

struct Input {
    std::string scene;
    std::vector<Override> overrides;
};

/// "--set KEY=VALUE", where it is one that a person may type.
std::optional<Override> override_of(std::string_view line) {
    constexpr std::string_view set = "--set ";
    constexpr std::size_t longest_key = 200;    // [bytes]
    const std::size_t equals = line.find('=');
    if (!line.starts_with(set) || equals == std::string_view::npos || equals > longest_key) return std::nullopt;
    return Override{std::string(line.substr(set.size(), equals - set.size())), std::string(line.substr(equals + 1))};
}

Input input_of(std::string_view bytes) {
    Input input;
    while (!bytes.empty()) {
        const std::size_t end = bytes.find('\n');
        if (const auto override = override_of(bytes.substr(0, end))) {
            input.overrides.push_back(*override);
        } else {
            input.scene += bytes.substr(0, end == std::string_view::npos ? end : end + 1);
        }
        bytes.remove_prefix(std::min(end, bytes.size() - 1) + 1);
    }
    return input;
}

/// A mesh as fine as it is asked for takes as long as it must; what is looked for here shows on a coarse one.
bool is_made_soon(const Scene& scene) {
    constexpr double most_cells = 200.0;
    if (!scene.tissue || scene.tissue->type != "corotational_fem") return true;
    const Parameters& parameters = scene.tissue->parameters;
    return !parameters.has("cells") || parameters.vector3("cells").prod() <= most_cells;
}

void read(const Input& input, const fs::path& file, const PluginFolders& folders) {
    fuzzing::write(file, input.scene);
    try {
        const Scene scene = read_scene(file, input.overrides, folders);
        if (is_made_soon(scene)) const Cast cast(scene, folders);
    } catch (const SceneErrors& errors) {
        fuzzing::demand(!errors.messages().empty(), "a refused scene is told why");
        for (const std::string& message : errors.messages()) {
            fuzzing::demand_sentence(message);
            fuzzing::demand_printable(message);
        }
    }
}

}    // namespace
}    // namespace stylet::core

// UDUNITS-2 loses a unit's name where what follows is none: some bytes for each such mistake, in a parser that is not ours.
extern "C" const char* __lsan_default_suppressions() {    // NOLINT(bugprone-reserved-identifier)
    return "leak:utlex\n";
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace stylet::core;
    static const SceneTree tree;
    static const PluginFolders folders = PluginFolders::standard();
    static const std::vector<PluginLibrary> libraries = open_all(folders);
    read(input_of(stylet::fuzzing::bytes_of(data, size)), tree.scene(), folders);
    return 0;
}
