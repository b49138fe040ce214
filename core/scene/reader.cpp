#include "core/scene/reader.h"

#include "core/run/sample.h"
#include "core/scene/overrides.h"
#include "core/scene/scene_format.h"
#include "core/scene/scene_hash.h"
#include "core/scene/sections.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

namespace stylet::core {
namespace {

constexpr std::size_t largest_scene = 1 << 20;    // [bytes] a written scene has some thousand; more is no scene

[[noreturn]] void refuse(const Place& place, const std::string& path, const std::string& sentence) {
    Complaints complaints;
    complaints.add(place, path, sentence);
    throw SceneErrors(complaints.messages());
}

/// Where the first byte stands that is no UTF-8, or npos.
std::size_t not_utf8(const std::string& text) {
    for (std::size_t i = 0; i < text.size();) {
        const auto byte = static_cast<unsigned char>(text[i]);
        const std::size_t more = byte < 0x80                   ? 0
                                 : byte >= 0xC2 && byte < 0xE0 ? 1
                                 : byte >= 0xE0 && byte < 0xF0 ? 2
                                 : byte >= 0xF0 && byte < 0xF5 ? 3
                                                               : 4;
        for (std::size_t k = 1; k <= more; ++k) {
            const bool continues = more < 4 && i + k < text.size() && (static_cast<unsigned char>(text[i + k]) & 0xC0) == 0x80;
            if (!continues) return i;
        }
        i += more + 1;
    }
    return std::string::npos;
}

std::string text_of(const std::filesystem::path& file) {
    try {
        std::string text = read_bytes(file, largest_scene);
        if (const std::size_t at = not_utf8(text); at != std::string::npos) {
            const auto line =
                static_cast<int>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n')) + 1;
            const auto column = static_cast<int>(at - (text.rfind('\n', at) + 1)) + 1;
            refuse({file.string(), line, column}, "", "found a byte that is no UTF-8, wanted a scene in UTF-8");
        }
        return text;
    } catch (const Error& error) {
        refuse({file.string(), 0, 0}, "", fmt::format("{}, wanted a scene", error.what()));
    }
}

/// A scene of another version may mean anything: what else is wrong with it cannot be told.
void check_version(const ValueTree& root, Reading& reading) {
    const ValueTree* version = root.find("stylet");
    const std::string wanted = fmt::format("{} (the version of the scene format)", format_version);
    if (version == nullptr) {
        miss_key(root, "stylet", wanted, reading);
    } else if (version->text != std::to_string(format_version)) {
        refuse(version->place, "stylet", "found " + version->description() + ", wanted " + wanted);
    }
}

using ReadSection = void (*)(const ValueTree&, Reading&, Scene&);
constexpr std::pair<const Section*, ReadSection> readers[] = {
    {&tissue_section, read_tissue},     {&needle_section, read_needle}, {&device_section, read_device},
    {&coupling_section, read_coupling}, {&run_section, read_run},       {&effects_section, read_effects},
    {&record_section, read_record},
};
static_assert(std::ranges::equal(sections, readers, {}, {}, [](const auto& reader) { return reader.first; }));

/// What the sections that are there ask for, and what has no place beside those that are not.
void check_sections(const ValueTree& root, Reading& reading) {
    const auto has = [&](const char* key) { return root.find(key) != nullptr; };
    const auto want = [&](const Section& section, const char* otherwise = "") {
        if (!has(section.key)) miss_key(root, section.key, fmt::format("a map ({}){}", section.meaning, otherwise), reading);
    };
    const auto refuse_beside = [&](const char* key, const std::string& sentence) {
        if (const ValueTree* section = root.find(key)) reading.complaints.add(section->place, key, sentence);
    };
    const bool tissue = has("tissue"), needle = has("needle");
    want(run_section);
    if (!tissue && !needle) {
        want(tissue_section, ", or a needle, or both");
    } else if (tissue && needle) {
        want(device_section);
        want(coupling_section);
    } else if (needle) {
        refuse_beside("coupling", "found a coupling, wanted none: there is no 'tissue' for the needle to meet");
    } else {
        refuse_beside("coupling", "found a coupling, wanted none: there is no 'needle' for the tissue to meet");
        refuse_beside("device", "found a device, wanted none: there is no 'needle' for it to hold");
    }
    const ValueTree* run = root.find("run");
    if (run != nullptr && run->shape == ValueTree::Shape::map && (tissue || needle) && !has("device") && !run->find("duration")) {
        miss_key(*run, "run.duration", "a time in s such as '2 s' (without a device the scene has no end of its own)", reading);
    }
}

void read_sections(const ValueTree& root, Reading& reading, Scene& scene) {
    std::vector<std::string> known{"stylet"};
    std::ranges::copy(names_of(scene_keys), std::back_inserter(known));
    for (const auto& [section, read] : readers) {
        known.emplace_back(section->key);
        const ValueTree* found = root.find(section->key);
        if (found == nullptr) continue;
        const bool of_its_shape =
            section->shape != Section::Shape::map || is_map(*found, section->key, section->meaning, reading);
        if (of_its_shape) read(*found, reading, scene);
    }
    check_sections(root, reading);
    refuse_unknown_keys(root, "", known, reading);
}

ValueTree tree_of(const std::string& text, const std::filesystem::path& file, const std::vector<Override>& overrides,
                  Complaints& complaints) {
    const Place start{file.string(), 1, 1};
    std::optional<ValueTree> root = parse_yaml(text, start, complaints);
    if (!root) throw SceneErrors(complaints.messages());
    if (root->shape == ValueTree::Shape::nothing) {
        refuse(start, "", fmt::format("found an empty file, wanted a scene that begins with 'stylet: {}'", format_version));
    }
    if (root->shape != ValueTree::Shape::map)
        refuse(root->place, "", "found " + root->description() + ", wanted a map of a scene's keys");
    apply_overrides(overrides, *root, complaints);
    return *std::move(root);
}

}    // namespace

Scene read_scene(const std::filesystem::path& file, const std::vector<Override>& overrides, const PluginFolders& folders) {
    const std::string text = text_of(file);
    Reading reading{.files = SceneFiles(file), .folders = folders};
    const ValueTree root = tree_of(text, file, overrides, reading.complaints);
    check_version(root, reading);
    Scene scene{};
    scene.file = file;
    const Parameters keys = read_parameters(root, "", scene_keys, reading);
    if (keys.has("title")) scene.title = keys.text("title");
    read_sections(root, reading, scene);
    reading.complaints.throw_if_any();
    if (scene.record.empty()) {
        for (const Column& column : all_columns()) {
            if (there(column, scene.needle.has_value(), scene.tissue.has_value())) scene.record.emplace_back(column.name);
        }
    }
    scene.places = std::move(reading.places);
    try {
        scene.hash = scene_hash(text, overrides, reading.files.named());
    } catch (const Error& error) {
        refuse({file.string(), 0, 0}, "", error.what());
    }
    return scene;
}

std::string scene_title(const std::filesystem::path& file) {
    try {
        Complaints complaints;
        const auto root = parse_yaml(read_bytes(file, largest_scene), {file.string(), 1, 1}, complaints);
        const ValueTree* title = root ? root->find("title") : nullptr;
        return title == nullptr ? "" : title->text;
    } catch (const Error&) {
        return "";
    }
}

}    // namespace stylet::core
