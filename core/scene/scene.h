// A scene as read: every value checked, in SI. Nothing here knows YAML, and nothing here is loaded yet.
#pragma once

#include <stylet/setup.h>

#include <filesystem>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace stylet::core {

/// Where something stands in a scene; line and column count from 1, both 0 where a `--set` put it.
struct Place {
    std::string file;
    int line = 0;
    int column = 0;
};

/// A plugin that the scene names, with its parameters.
struct Choice {
    std::string type;
    std::string path;    // in the scene, for instance effects[1]
    Place place;         // of its `type`
    Parameters parameters;
    std::string within = path;                  // where its own parameters stand: effects[1], needle.rod
    std::vector<std::string> alternatives{};    // other plugins of the role that a swappable section holds maps for
};

struct RunSetup {
    double rate;                       // [Hz]
    std::optional<double> duration;    // [s]; absent: as long as the device's motion

    [[nodiscard]] double dt() const { return 1.0 / rate; }    // [s]
};

struct Scene {
    std::filesystem::path file;
    std::string title;
    std::string hash;    // SHA-1 of the scene's text with its overrides and of every file that it names

    // What a scene doesn't name is not there: a tissue alone, or a needle alone in air, is a scene too.
    std::optional<Choice> tissue;
    std::optional<TissueSetup> tissue_setup;
    std::optional<Choice> needle;
    std::optional<NeedleSetup> needle_setup;
    std::string gauge;    // of the needle, as the scene names it; empty where it gives radii
    std::optional<Choice> buckling;
    std::vector<Choice> effects;
    std::optional<Choice> device;
    std::optional<double> force_limit;    // [N] lower than the device's own

    double contact_spacing = std::numeric_limits<double>::infinity();    // [m] infinite where there is nothing to couple
    RunSetup run;
    std::vector<std::string>
        record;    // columns or groups of them, in the scene's order; every column where the scene names none

    std::map<std::string, Place> places;    // where each parameter stands, by its path: needle.length, effects[1].toughness
};

}    // namespace stylet::core
