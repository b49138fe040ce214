#include "apps/stylet/kinds.h"
#include "apps/stylet/plugin_text.h"
#include "core/scene/wanted.h"

#include <nlohmann/json.hpp>

#include <cmath>

namespace stylet::app {
namespace {

using nlohmann::ordered_json;

ordered_json parameters_json(ParameterList parameters);

ordered_json bound(double value) {
    return std::isfinite(value) ? ordered_json(value) : ordered_json(nullptr);
}

ordered_json parameter_json(const Parameter& parameter) {
    ordered_json json{{"name", parameter.name},
                      {"kind", name_of(parameter.kind)},
                      {"unit", parameter.unit},
                      {"required", parameter.need == Need::required},
                      {"meaning", parameter.meaning}};
    if (has_range(parameter.kind)) {
        json["range"] = {{"least", bound(parameter.range.least)},
                         {"open_below", parameter.range.open_below},
                         {"greatest", bound(parameter.range.greatest)},
                         {"open_above", parameter.range.open_above}};
    }
    if (parameter.finer != Finer::neither) json["finer"] = parameter.finer == Finer::above ? "above" : "below";
    if (parameter.kind == Kind::choice) json["choices"] = core::choices_of(parameter);
    if (parameter.kind == Kind::records) json["fields"] = parameters_json(fields_of(parameter));
    return json;
}

ordered_json parameters_json(ParameterList parameters) {
    ordered_json all = ordered_json::array();
    for (const Parameter& parameter : parameters) all.push_back(parameter_json(parameter));
    return all;
}

ordered_json described(const core::PluginLibrary& library) {
    const Descriptor& plugin = library.descriptor();
    return {{"name", plugin.name},
            {"role", core::name_of(plugin.role)},
            {"summary", plugin.about.summary},
            {"formula", plugin.about.formula},
            {"source", plugin.about.source},
            {"validity", plugin.about.validity},
            {"file", library.file().string()},
            {"parameters", parameters_json(parameters_of(plugin))}};
}

std::string text_of(const ordered_json& json) {
    return json.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

}    // namespace

std::string plugin_json(const core::PluginLibrary& library) {
    return text_of(described(library));
}

std::string plugins_json(std::span<const core::PluginLibrary> libraries) {
    ordered_json all = ordered_json::array();
    for (const core::PluginLibrary& library : libraries) all.push_back(described(library));
    return text_of(all);
}

}    // namespace stylet::app
