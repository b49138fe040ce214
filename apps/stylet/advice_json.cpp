#include "apps/stylet/advice_text.h"

#include "apps/stylet/study_words.h"

#include <nlohmann/json.hpp>

#include <cmath>

namespace stylet::app {
namespace {

using nlohmann::ordered_json;

/// JSON has no infinity.
ordered_json number(double value) {
    return std::isfinite(value) ? ordered_json(value) : ordered_json(nullptr);
}

ordered_json timing_json(const std::optional<study::Timing>& timing) {
    if (!timing) return nullptr;
    return {{"median_us", timing->median},
            {"p99_us", timing->p99},
            {"worst_us", timing->worst},
            {"mean_us", timing->mean},
            {"contended", timing->contended}};
}

ordered_json changes_json(const std::vector<core::Override>& changes) {
    ordered_json set = ordered_json::object();
    for (const core::Override& change : changes) set[change.key] = change.value;
    return set;
}

ordered_json setting_json(const study::Weighed& setting, const study::Wish& wish) {
    ordered_json json{{"name", setting.neighbour.name},
                      {"set", changes_json(setting.neighbour.changes)},
                      {"error", number(setting.error)},
                      {"tick", timing_json(setting.timing)},
                      {"within_budget", setting.in_time(wish)},
                      {"under_error", setting.near_enough(wish)},
                      {"remarks", setting.remarks}};
    if (!setting.why.empty()) json["why"] = setting.why;
    return json;
}

ordered_json omission_json(const study::Omission& omission) {
    ordered_json json{{"effect", omission.neighbour.name}, {"key", omission.neighbour.changes.front().key}};
    if (!omission.why.empty()) {
        json["why"] = omission.why;
        return json;
    }
    json["other_run"] = omission.other_run;
    json["costs_us"] = omission.other_run || !std::isfinite(omission.noise) ? ordered_json(nullptr) : number(omission.cost);
    json["noise_us"] = number(omission.noise);
    json["changes"] = number(omission.change);
    json["largest_without"] = number(omission.largest);
    return json;
}

/// The setting's name, or null.
ordered_json name_of(const study::Advice& advice, const std::optional<std::size_t>& index) {
    return index ? ordered_json(advice.settings[*index].neighbour.name) : ordered_json(nullptr);
}

}    // namespace

std::string advice_json(const study::Advice& advice) {
    ordered_json settings = ordered_json::array(), omissions = ordered_json::array(), left_out = ordered_json::array();
    for (const study::Weighed& setting : advice.settings) settings.push_back(setting_json(setting, advice.wish));
    for (const study::Omission& omission : advice.omissions) omissions.push_back(omission_json(omission));
    for (const study::LeftOut& one : advice.left_out) left_out.push_back({{"name", one.name}, {"why", one.why}});
    const ordered_json json{{"title", advice.title},
                            {"scene", advice.scene.string()},
                            {"set", changes_json(advice.changes)},
                            {"mind", advice.mind},
                            {"budget_s", advice.wish.budget},
                            {"error", advice.wish.error},
                            {"column", advice.column},
                            {"unit", advice.unit},
                            {"reference",
                             {{"name", advice.reference.name},
                              {"why", advice.reference.why},
                              {"set", changes_json(advice.reference.changes)},
                              {"largest", number(advice.reference.largest)},
                              {"tick", timing_json(advice.reference.timing)}}},
                            {"settings", settings},
                            {"take", name_of(advice, advice.take)},
                            {"cheapest_under_error", name_of(advice, advice.cheapest)},
                            {"nearest_within_budget", name_of(advice, advice.nearest)},
                            {"effects_of", advice.settings[advice.examined].neighbour.name},
                            {"largest", number(advice.largest)},
                            {"effects", omissions},
                            {"left_out", left_out},
                            {"threads", advice.threads},
                            {"machine", machine_text(advice.machine)}};
    return json.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

}    // namespace stylet::app
