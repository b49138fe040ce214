// A scene played tick by tick inside the test, and what it left behind.
#pragma once

#include "core/loading/cast.h"
#include "core/run/simulation.h"
#include "core/scene/reader.h"
#include "tests/whole_scenes/plugins/driven_hand.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace stylet::whole_scenes {

using Overrides = std::vector<core::Override>;
using Motion = std::function<Pose(double time)>;

/// The build's own plugins, and those of these tests.
[[nodiscard]] core::PluginFolders plugin_folders();

[[nodiscard]] std::filesystem::path paper_scene(const std::string& name);         // of scenes/paper
[[nodiscard]] std::filesystem::path validation_scene(const std::string& name);    // of scenes/validation
[[nodiscard]] std::filesystem::path own_scene(const std::string& name);           // of the scenes beside these tests

/// A scene with its cast, ready to tick. A motion drives the scene's driven_hand.
class Stage {
public:
    explicit Stage(const std::filesystem::path& scene, const Overrides& overrides = {}, Motion motion = {});

    [[nodiscard]] const core::Scene& scene() const { return scene_; }
    [[nodiscard]] const core::Cast& cast() const { return cast_; }
    [[nodiscard]] core::Simulation& simulation() { return *simulation_; }
    [[nodiscard]] DrivenHand& hand() const;            // of a scene whose device is driven_hand
    [[nodiscard]] std::size_t ticks() const;           // until the scene's end
    [[nodiscard]] double most_device_force() const;    // [N] that may ever be written to the device

private:
    core::Scene scene_;
    core::Cast cast_;
    std::optional<core::Simulation> simulation_;
};

struct Happening {
    std::string name;
    std::size_t tick;                    // index into the samples
    double time;                         // [s]
    double travel, depth;                // [m]
    double hand_force, critical_load;    // [N]
};

struct Trace {
    std::vector<core::Sample> samples;    // one after each tick
    std::vector<Happening> events;
    double peak_work = 0.0;            // [J]
    double relative = 0.0;             // largest residual over peak work
    double relative_pushing = 0.0;     // the same until the first puncture
    double most_device_force = 0.0;    // [N] that may ever be written to the device

    [[nodiscard]] std::vector<std::string> names() const;
    [[nodiscard]] std::size_t count(const std::string& name) const;
    [[nodiscard]] const Happening* first(const std::string& name) const;    // nullptr where it did not happen
    [[nodiscard]] double peak_hand_force() const;                           // [N] largest magnitude
    [[nodiscard]] bool near_event(std::size_t tick, std::size_t margin) const;
};

/// Plays all of a scene, or `ticks` of it.
[[nodiscard]] Trace play(Stage& stage, std::optional<std::size_t> ticks = {});
[[nodiscard]] Trace play(const std::filesystem::path& scene, const Overrides& overrides = {}, Motion motion = {},
                         std::optional<std::size_t> ticks = {});

/// What every hard case requires besides its own: nothing NaN or infinite, the force at the device within its limit, and no
/// energy made or lost beyond `residual` of the peak work.
inline constexpr double sound_residual = 1e-3;    // the bound for every scene
void expect_sound(const Trace& trace, double residual = sound_residual);

/// Prints a measured figure and keeps it with the test's result.
void measured(const std::string& name, double value, const std::string& unit = "");
void print_events(const Trace& trace);

/// The base of a needle of this length that points straight down with its tip at depth `depth` [m].
[[nodiscard]] Pose tip_at(double depth, double needle_length);

}    // namespace stylet::whole_scenes
