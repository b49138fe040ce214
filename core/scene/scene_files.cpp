#include "core/scene/scene_files.h"

#include "core/scene/complaints.h"

#include <stylet/error.h>

#include <fmt/format.h>

#include <algorithm>
#include <fstream>

namespace stylet::core {
namespace {

namespace fs = std::filesystem;

fs::path tree_of(const fs::path& folder) {
    for (fs::path at = folder; at.has_relative_path(); at = at.parent_path()) {
        if (at.filename() == "scenes") return at;
    }
    return folder;
}

bool lies_in(const fs::path& file, const fs::path& folder) {
    return std::ranges::mismatch(folder, file).in1 == folder.end();
}

}    // namespace

SceneFiles::SceneFiles(const fs::path& scene) {
    std::error_code unreadable;    // a scene that is not there is complained of when it is read
    folder_ = fs::weakly_canonical(fs::absolute(scene), unreadable).parent_path();
    root_ = tree_of(folder_);
}

SceneFiles::Found SceneFiles::find(const std::string& name) {
    const fs::path given(name);
    if (given.is_absolute()) return {{}, fmt::format("the absolute path {}", quote(name))};
    if (name.find('\0') != std::string::npos) return {{}, fmt::format("{}", quote(name))};
    std::error_code error;
    const fs::path file = fs::weakly_canonical(folder_ / given, error);
    if (error) return {{}, fmt::format("{}, which cannot be followed ({})", quote(name), error.message())};
    // Before anything is asked of the file: a scene learns nothing of what lies outside its tree.
    if (!lies_in(file, root_)) return {{}, fmt::format("{}, which leaves the scene's folder tree", quote(name))};
    if (!fs::exists(file, error)) return {{}, fmt::format("{}, which is not there", quote(name))};
    if (!fs::is_regular_file(file, error)) return {{}, fmt::format("{}, which is no file", quote(name))};
    named_.push_back(file);
    return {file, ""};
}

std::string read_bytes(const fs::path& file, std::size_t longest) {
    std::error_code error;
    if (!fs::exists(file, error)) throw Error("found no such file");
    if (!fs::is_regular_file(file, error)) throw Error("found something that is no file");
    const std::uintmax_t size = fs::file_size(file, error);
    if (error) throw Error(fmt::format("found a file that cannot be read ({})", error.message()));
    if (size > longest) throw Error(fmt::format("found a file of {} bytes (at most {} are read)", size, longest));
    std::string bytes(size, '\0');
    std::ifstream stream(file, std::ios::binary);
    if (!stream.read(bytes.data(), static_cast<std::streamsize>(size))) throw Error("found a file that cannot be read");
    return bytes;
}

}    // namespace stylet::core
