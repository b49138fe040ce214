// Which setting of a scene to take, and what each of its effects costs and does.
#pragma once

#include "apps/study/neighbours.h"
#include "apps/study/result.h"

#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace stylet::study {

/// What is asked of a setting.
struct Wish {
    double budget;    // [s] for a tick
    double error;     // relative, at most

    /// A gain that is less than this share, of the error asked for or of a tick, is not worth another setting.
    static constexpr double idle = 0.1;
    [[nodiscard]] double idle_error() const { return idle * error; }
};

/// A neighbour of the scene, measured.
struct Weighed {
    Neighbour neighbour;
    bool other_models = false;                                 // a step of one parameter otherwise
    double error = std::numeric_limits<double>::infinity();    // against the reference
    std::string why{};                                         // there is no error
    std::optional<Timing> timing{};                            // of a tick
    std::vector<std::string> remarks{};

    /// 99 of 100 ticks are; of a machine that was busy, half of them: its slow ticks are not the models'.
    [[nodiscard]] bool in_time(const Wish& wish) const;
    [[nodiscard]] bool near_enough(const Wish& wish) const { return error <= wish.error; }

    /// How many ticks a second has is the hand's to say: another rate shows what it changes, and is not to be taken.
    [[nodiscard]] bool same_rate() const;
};

/// What the settings are compared with.
struct ReferenceSetting {
    std::string name;                       // "half_space, rod"
    std::string why;                        // this one
    std::vector<core::Override> changes;    // that make it, on top of the scene
    std::optional<Timing> timing{};
    double largest = 0.0;    // of the curve, in its unit
};

/// What a setting does without one of its effects.
struct Omission {
    Neighbour neighbour;
    std::string why{};         // it cannot be left out; empty where it can
    double cost = 0.0;         // [µs] of the mean tick; negative where it takes longer without
    double noise = 0.0;        // [µs] below it a cost says nothing; infinite where the machine was busy
    bool other_run = false;    // with and without it not the same happens: there is no telling what it costs
    double change = 0.0;       // RMS of the curve's difference, as a share of its largest value
    double largest = 0.0;      // of the curve without it
};

struct Advice {
    std::string title;
    std::filesystem::path scene;
    std::vector<core::Override> changes;    // by the user, on every run
    Wish wish;
    std::vector<std::string> mind{};    // before all that follows
    std::string column, unit;           // of the curve, over time: hand_force, N
    ReferenceSetting reference;
    std::vector<Weighed> settings;    // the scene itself first
    // Of settings whose gain is idle the first: the scene itself, if it is among them.
    std::optional<std::size_t> take;        // the most accurate of those in time, where it is near enough
    std::optional<std::size_t> cheapest;    // of those near enough
    std::optional<std::size_t> nearest;     // of those in time
    std::size_t examined = 0;               // whose effects were left out: what to take, or else the scene itself
    double largest = 0.0;                   // of its curve
    std::vector<Omission> omissions;
    std::vector<LeftOut> left_out;
    Machine machine;
    int threads = 1;
};

/// The models to compare with: the first whose median tick is not clearly below the costliest one's. Clocks are noisy, and the
/// first are the scene's own. Only of those that ran to their end; the first of all where none did.
[[nodiscard]] std::size_t costliest(const std::vector<Weighed>& settings);

/// Says which to take, once all settings are measured.
void choose(Advice& advice);

}    // namespace stylet::study
