// The critical loads of needles by one or more models, along the insertion or along any key of the scene.
#pragma once

#include "apps/study/interval.h"
#include "apps/stylet/load_models.h"
#include "core/loading/plugin_folders.h"

#include <optional>
#include <string>
#include <vector>

namespace stylet::app {

/// A key of the scene, and what it is to become.
struct VariedKey {
    std::string key;    // needle.radius
    study::Interval values;
};

struct LoadQuestion {
    std::vector<std::string> scenes;    // files
    std::vector<core::Override> overrides;
    core::PluginFolders folders;
    std::vector<AskedModel> models;          // none: each scene's own
    std::optional<study::Interval> depth;    // none: the whole insertion, or the surface where a key varies
    std::optional<VariedKey> varied;         // goes with one depth
    int points = 51;                         // of an interval
    bool stiffness = false;                  // Eq. (3)'s spring constant, too
};

/// One model's answers for one scene.
struct LoadCurve {
    std::string model{};                       // its label
    std::vector<double> loads{};               // [N] at each point; NaN where the model knows air alone and none is left
    std::vector<double> stiffness{};           // [Pa] at each point, where it was asked for
    std::optional<double> at_surface{};        // [N] where the tip is about to puncture; none where a key varies
    std::vector<double> crossings{};           // where the load changes sides with the puncture force, in the unit of the axis
    std::vector<double> inside_crossings{};    // where it changes sides with the insertion force
};

struct SceneLoads {
    std::string file;    // as the user named it
    std::string name;    // the file's without its ending, and as much of its folder as tells it from the others
    std::string title;
    std::string hash;
    NeedleSetup needle;
    std::string gauge;          // empty where the scene gives radii
    std::string needle_type;    // the plugin
    bool has_buckling;          // a run of the scene asks a buckling model
    bool has_tissue;
    std::vector<double> points;       // in the unit of the axis
    std::vector<double> puncture;     // [N] force at which the tip punctures, at each point; infinite where nothing limits it
    std::vector<double> insertion;    // [N] force at which the needle goes on inside, at each point; infinite where it cannot
    std::vector<LoadCurve> curves;
    std::optional<double> reference{};    // [N] a known load

    [[nodiscard]] const LoadCurve* curve(const std::string& model) const;
};

struct CriticalLoads {
    std::string axis;      // "inserted", or the varied key
    std::string unit;      // of the axis; empty where it has none
    bool along_depth;      // or else along the varied key, at `depth`
    bool whole;            // the insertion, from its beginning to its end
    bool stiffness;        // Eq. (3)'s was asked for
    double depth = 0.0;    // [m] inserted
    std::vector<SceneLoads> scenes;

    /// Of all scenes, in the order of their appearance.
    [[nodiscard]] std::vector<std::string> models() const;
    /// Each scene has one point: a table of scenes.
    [[nodiscard]] bool one_point() const;
};

/// Reads each scene for each point and model, so that each is checked as any scene. Throws core::SceneErrors with all that is
/// wrong with scenes, models and depths.
[[nodiscard]] CriticalLoads critical_loads(const LoadQuestion& question);

}    // namespace stylet::app
