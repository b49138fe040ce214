#include "apps/stylet/load_models.h"

#include "apps/stylet/failure.h"
#include "apps/stylet/scene_arguments.h"
#include "core/scene/complaints.h"

#include <fmt/format.h>

namespace stylet::app {
namespace {

constexpr const char* section = "needle.buckling";

/// At the commas, but for those within brackets of any kind.
std::vector<std::string> parts_of(const std::string& text) {
    std::vector<std::string> parts{""};
    int depth = 0;
    for (const char c : text) {
        depth += c == '[' || c == '{' ? 1 : c == ']' || c == '}' ? -1 : 0;
        if (c == ',' && depth <= 0) {
            parts.emplace_back();
        } else {
            parts.back() += c;
        }
    }
    return parts;
}

AskedModel model(const std::string& type, const std::string& given) {
    return {.type = type, .changes = {}, .overrides = {{fmt::format("{}.type", section), type, given, true}}};
}

}    // namespace

std::string AskedModel::label() const {
    return core::printable(changes.empty() ? type : fmt::format("{} {}", type, fmt::join(changes, " ")));
}

AskedModel read_asked_model(const std::string& text) {
    const std::string given = "--model " + core::printable(text);
    const std::vector<std::string> parts = parts_of(text);
    AskedModel asked = model(parts.front(), given);
    bool sound = !parts.front().empty() && parts.front().find('=') == std::string::npos;
    for (std::size_t i = 1; i < parts.size() && sound; ++i) {
        const auto change = read_key_value(parts[i]);
        sound = change.has_value();
        if (!sound) break;
        const std::string key = fmt::format("{}.{}.{}", section, asked.type, change->key);
        asked.overrides.push_back({key, change->value, given, true});
        asked.changes.push_back(parts[i]);
    }
    if (sound) return asked;
    throw Failure(
        ExitCode::wrong_command,
        fmt::format("--model: found {}, wanted NAME or NAME,KEY=VALUE, for instance foundation,form=printed", core::quote(text)));
}

std::vector<AskedModel> models_of(const core::Scene& scene) {
    std::vector<AskedModel> models;
    if (!scene.buckling) return models;
    models.push_back({.type = scene.buckling->type, .changes = {}, .overrides = {}});
    for (const std::string& other : scene.buckling->alternatives)
        models.push_back(model(other, fmt::format("{}: {}.{}", scene.file.string(), section, other)));
    return models;
}

}    // namespace stylet::app
