#include "core/scene/reader.h"

#include "core/run/sample.h"
#include "core/scene/document.h"
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

constexpr const char* kind = "a scene";

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

/// What the file says, where it says anything.
std::optional<ValueTree> tree_in(const std::filesystem::path& file) {
    try {
        Complaints complaints;
        return document_tree(document_text(file, kind), file, kind, complaints);
    } catch (const SceneErrors&) {
        return std::nullopt;
    }
}

}    // namespace

Scene read_scene(const std::filesystem::path& file, const std::vector<Override>& overrides, const PluginFolders& folders) {
    const std::string text = document_text(file, kind);
    Reading reading{.files = SceneFiles(file), .folders = folders};
    ValueTree root = document_tree(text, file, kind, reading.complaints);
    if (is_study(root))
        throw SceneErrors({fmt::format("{}: found a study, wanted a scene; stylet study runs it", file.string())});
    apply_overrides(overrides, root, reading.complaints);
    check_version(root, kind, reading);
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
        throw SceneErrors({fmt::format("{}: {}", file.string(), error.what())});
    }
    return scene;
}

std::string scene_title(const std::filesystem::path& file) {
    const std::optional<ValueTree> root = tree_in(file);
    const ValueTree* title = root && !is_study(*root) ? root->find("title") : nullptr;
    return title == nullptr ? "" : title->text;
}

bool holds_study(const std::filesystem::path& file) {
    const std::optional<ValueTree> root = tree_in(file);
    return root && is_study(*root);
}

}    // namespace stylet::core
