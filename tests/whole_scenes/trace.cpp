#include "tests/whole_scenes/trace.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <span>

namespace stylet::whole_scenes {

core::PluginFolders plugin_folders() {
    return core::PluginFolders({PLUGIN_FOLDER, TEST_PLUGIN_FOLDER});
}

std::filesystem::path paper_scene(const std::string& name) {
    return std::filesystem::path(SCENE_FOLDER) / "paper" / (name + ".yaml");
}

std::filesystem::path validation_scene(const std::string& name) {
    return std::filesystem::path(SCENE_FOLDER) / "validation" / (name + ".yaml");
}

std::filesystem::path own_scene(const std::string& name) {
    return std::filesystem::path(OWN_SCENE_FOLDER) / (name + ".yaml");
}

Stage::Stage(const std::filesystem::path& scene, const Overrides& overrides, Motion motion)
    : scene_(core::read_scene(scene, overrides, plugin_folders())), cast_(scene_, plugin_folders()) {
    if (motion) hand().motion = std::move(motion);
    simulation_.emplace(scene_, cast_);
}

DrivenHand& Stage::hand() const {
    if (!scene_.device || scene_.device->type != "driven_hand")
        throw std::logic_error("only a driven_hand can be given a motion");
    return static_cast<DrivenHand&>(cast_.device());
}

std::size_t Stage::ticks() const {
    const double duration = scene_.run.duration.value_or(cast_.device().duration());
    return static_cast<std::size_t>(std::llround(duration * scene_.run.rate));
}

double Stage::most_device_force() const {
    const double device = cast_.device().limits().force;
    return std::min(device, scene_.force_limit.value_or(device));
}

std::vector<std::string> Trace::names() const {
    std::vector<std::string> names;
    for (const Happening& event : events) names.push_back(event.name);
    return names;
}

std::size_t Trace::count(const std::string& name) const {
    return static_cast<std::size_t>(std::ranges::count(events, name, &Happening::name));
}

const Happening* Trace::first(const std::string& name) const {
    const auto found = std::ranges::find(events, name, &Happening::name);
    return found == events.end() ? nullptr : &*found;
}

double Trace::peak_hand_force() const {
    double peak = 0.0;
    for (const core::Sample& sample : samples) peak = std::max(peak, std::abs(sample.hand_force));
    return peak;
}

bool Trace::near_event(std::size_t tick, std::size_t margin) const {
    return std::ranges::any_of(
        events, [&](const Happening& event) { return tick + margin >= event.tick && tick <= event.tick + margin; });
}

Trace play(Stage& stage, std::optional<std::size_t> ticks) {
    Trace trace;
    trace.most_device_force = stage.most_device_force();
    core::Simulation& simulation = stage.simulation();
    const core::Ledger& ledger = simulation.ledger();
    const auto relative = [&] { return ledger.peak_work() > 0.0 ? ledger.peak_residual() / ledger.peak_work() : 0.0; };
    const std::size_t count = ticks.value_or(stage.ticks());
    trace.samples.reserve(count);
    for (std::size_t tick = 0; tick < count; ++tick) {
        simulation.tick();
        trace.samples.push_back(simulation.sample());
        for (const core::Event& event : simulation.events()) {
            trace.events.push_back(
                {event.name, tick, event.time, event.travel, event.depth, event.hand_force, event.critical_load});
        }
        if (!simulation.ever_punctured()) trace.relative_pushing = relative();
    }
    trace.peak_work = ledger.peak_work();
    trace.relative = relative();
    return trace;
}

Trace play(const std::filesystem::path& scene, const Overrides& overrides, Motion motion, std::optional<std::size_t> ticks) {
    Stage stage(scene, overrides, std::move(motion));
    return play(stage, ticks);
}

void expect_sound(const Trace& trace, double residual) {
    constexpr double rounding = 1e-12;    // of the limit: shortening a vector to its limit rounds once
    for (const core::Sample& sample : trace.samples) {
        for (const core::Column& column : core::all_columns()) {
            const double value = sample.*column.value;
            const bool never_buckles = column.value == &core::Sample::critical_load && value > 0.0;
            ASSERT_TRUE(std::isfinite(value) || never_buckles) << column.name << " is " << value << " at " << sample.time << " s";
        }
        ASSERT_LE(std::abs(sample.device_force), trace.most_device_force * (1.0 + rounding)) << "at " << sample.time << " s";
    }
    EXPECT_LE(trace.relative, residual) << "of the peak work of " << trace.peak_work << " J";
}

void measured(const std::string& name, double value, const std::string& unit) {
    std::printf("  %s: %.9g %s\n", name.c_str(), value, unit.c_str());
    char text[40];
    std::snprintf(text, sizeof text, "%.9g %s", value, unit.c_str());
    testing::Test::RecordProperty(name, text);
}

void print_events(const Trace& trace) {
    constexpr std::size_t enough = 12;
    for (const Happening& event : std::span(trace.events).first(std::min(enough, trace.events.size()))) {
        std::printf("  %8.4f s  travel %8.4f mm  depth %8.4f mm  hand %8.5f N  critical %8.5f N  %s\n", event.time,
                    1e3 * event.travel, 1e3 * event.depth, event.hand_force, event.critical_load, event.name.c_str());
    }
    if (trace.events.size() > enough) std::printf("  and %zu events more\n", trace.events.size() - enough);
    std::printf("  residual %.3g of %.4g mJ (%.3g while pushing)\n", trace.relative, 1e3 * trace.peak_work,
                trace.relative_pushing);
}

Pose tip_at(double depth, double needle_length) {
    return {.position = {0.0, 0.0, needle_length - depth}};
}

}    // namespace stylet::whole_scenes
