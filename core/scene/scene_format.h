// What a scene is made of: its sections, the keys in each that are core's own, and where plugins come in. The reader follows it,
// and so does whatever describes the format.
#pragma once

#include "core/scene/common_keys.h"

#include <stylet/plugin.h>

#include <array>
#include <optional>
#include <span>

namespace stylet::core {

struct Section {
    enum class Shape { map, list_of_maps, list_of_words };

    const char* key;
    const char* meaning;
    Shape shape = Shape::map;
    std::span<const Parameter> keys{};    // core's own
    std::optional<Role> role{};           // of the plugin that its `type` names
    bool swappable = false;               // that plugin's parameters stand in a map named after it; else beside its `type`
    const Section* part = nullptr;        // a section within this one, that may be left out
};

inline constexpr Section buckling_section{
    .key = "buckling",
    .meaning = "the model of the critical load, for a needle that asks one; left out, such a needle never buckles",
    .role = Role::buckling,
    .swappable = true};
inline constexpr Section tissue_section{
    .key = "tissue", .meaning = "the tissue and its layers", .keys = tissue_keys, .role = Role::tissue, .swappable = true};
inline constexpr Section needle_section{.key = "needle",
                                        .meaning = "the needle",
                                        .keys = needle_keys,
                                        .role = Role::needle,
                                        .swappable = true,
                                        .part = &buckling_section};
inline constexpr Section device_section{
    .key = "device", .meaning = "what moves the needle's base", .keys = device_keys, .role = Role::device};
inline constexpr Section coupling_section{.key = "coupling", .meaning = "how needle and tissue meet", .keys = coupling_keys};
inline constexpr Section run_section{.key = "run", .meaning = "how fast and how long", .keys = run_keys};
inline constexpr Section effects_section{
    .key = "effects", .meaning = "effects that act", .shape = Section::Shape::list_of_maps, .role = Role::effect};
inline constexpr Section record_section{
    .key = "record", .meaning = "columns; left out, every column is recorded", .shape = Section::Shape::list_of_words};

/// In the order in which they are read: the coupling looks at the needle. Beside them a scene has only `stylet` (format_version)
/// and scene_keys. Which of them may be left out is check_sections' (reader.cpp).
inline constexpr std::array sections{&tissue_section, &needle_section,  &device_section, &coupling_section,
                                     &run_section,    &effects_section, &record_section};

}    // namespace stylet::core
