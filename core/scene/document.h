// A YAML file of this program's own format: a scene, a study. What is wrong with it as a file is said in one sentence.
#pragma once

#include "core/scene/parameter_reader.h"

#include <filesystem>
#include <string>

namespace stylet::core {

/// The file's text, which is UTF-8. `kind` is what it should hold, "a scene". Throws SceneErrors.
[[nodiscard]] std::string document_text(const std::filesystem::path& file, const std::string& kind);

/// What the text says: a map. Complains of bad YAML; throws SceneErrors where there is no map at all.
[[nodiscard]] ValueTree document_tree(const std::string& text, const std::filesystem::path& file, const std::string& kind,
                                      Complaints& complaints);

/// A document of another version may mean anything: what else is wrong with it cannot be told. Throws SceneErrors then; complains
/// where it names none.
void check_version(const ValueTree& root, const std::string& kind, Reading& reading);

/// A study is known by its series, which no scene has.
[[nodiscard]] bool is_study(const ValueTree& root);

}    // namespace stylet::core
