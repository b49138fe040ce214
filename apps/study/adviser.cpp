#include "apps/study/adviser.h"

#include "apps/study/changes.h"
#include "apps/study/errors.h"
#include "apps/study/job.h"
#include "apps/study/machine.h"
#include "apps/study/pace.h"
#include "apps/study/readable.h"
#include "apps/study/stopwatch.h"
#include "core/run/sample.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace stylet::study {
namespace {

constexpr double quick = 0.5;     // [s] a run that takes less is timed by several
constexpr int repetitions = 5;    // of those

/// Ends a run that would take too long.
struct GivenUp {
    double seconds;    // that it would have taken
};

/// Ends a run once it is clear that it takes too long. Loading is not counted: it tells nothing of the rest.
class Patience {
public:
    explicit Patience(double limit) : limit_(limit) {}

    /// That so much of the run is done. Throws GivenUp.
    void hear(double share) {
        constexpr double least = 1.0;    // [s] before which nothing is clear
        if (share <= 0.0) watch_.start();
        const double passed = watch_.wall();
        if (passed > least && passed > share * limit_) throw GivenUp{passed / share};
    }

private:
    double limit_;    // [s] for the whole run
    Stopwatch watch_;
};

/// The user asked for an end.
struct Stopped {};

std::string measured_column(const core::Scene& scene) {
    if (!scene.needle) return "patch_displacement";
    return scene.device ? "hand_force" : "deflection";
}

double largest_of(const Outcome& outcome) {
    double largest = 0.0;
    for (const double y : outcome.y) largest = std::max(largest, std::abs(y));
    return largest;
}

std::string words_of(const GivenUp& given_up) {
    constexpr double us = 1e6;    // in a second
    return "given up: it would take " + time_text(given_up.seconds * us);
}

/// "half_space, rod" with "cells=[24, 24, 9], rate=2 kHz"
std::string with_changes(const std::string& name, const std::vector<core::Override>& changes) {
    std::string text = name;
    const char* before = " with ";
    for (const core::Override& change : changes)
        text += fmt::format("{}{}={}", std::exchange(before, ", "), change.key, change.value);
    return text;
}

/// Runs of all rates shall cover the same time: before its first tick ends, a run counts as that leaves it.
void begin_at_0(Outcome& outcome) {
    if (outcome.x.empty()) return;
    outcome.x.insert(outcome.x.begin(), 0.0);
    outcome.y.insert(outcome.y.begin(), outcome.y.front());
}

/// What a run without an effect tells of it.
Omission omission_of(const Neighbour& omitted, const Outcome& with, const Outcome& without) {
    const ErrorOfOutcome change = error_of(without, with);
    const bool busy = with.timing->contended || without.timing->contended;    // a mean holds all that was waited for
    const double noise = busy ? INFINITY : Wish::idle;    // of a tick: two runs of the same setting differ by half as much
    return {.neighbour = omitted,
            .why = change.why,
            .cost = with.timing->mean - without.timing->mean,
            .noise = noise * with.timing->mean,
            .other_run = with.punctured != without.punctured,
            .change = change.error,
            .largest = largest_of(without)};
}

class Adviser {
public:
    Adviser(const Request& request, const std::atomic<bool>& stop, const std::function<void(const Progress&)>& progress)
        : request_(request),
          base_{request.scene, request.changes, request.folders},
          scene_(base_.read()),
          stop_(stop),
          progress_(progress) {}

    Advice advise() {
        if (request_.reference) (void)base_.read(*request_.reference);    // before anything is run
        begin();
        Neighbours neighbours = neighbours_of(base_);
        advice_.left_out = neighbours.left_out;
        pace_.expect(neighbours.models.size(), neighbours.steps.size(), omissions(scene_, request_.folders).size());
        weigh_all(neighbours.models, true);
        find_reference();
        weigh_all(neighbours.steps, false);
        compare();
        choose(advice_);
        leave_out();
        return std::move(advice_);
    }

private:
    void begin() {
        advice_.title = scene_.title;
        advice_.scene = request_.scene;
        advice_.changes = request_.changes;
        advice_.wish = {.budget = request_.budget.value_or(scene_.run.dt()), .error = request_.error};
        if (const auto mesh = load_by_mesh(scene_, request_.folders)) advice_.mind.push_back(*mesh);
        advice_.threads = request_.threads;
        advice_.machine = this_machine();
        advice_.column = measured_column(scene_);
        advice_.unit = core::column_named(advice_.column)->unit;
    }

    /// Throws GivenUp, Stopped, and core::SceneErrors where the changed scene is none.
    Outcome measured(const std::string& name, const std::vector<core::Override>& changes, double longest, Pace::Kind kind) {
        Job job{.scene = base_.read(changes),
                .name = name,
                .key = "",
                .measure = CurveMeasure{.column = advice_.column, .over = "time"},
                .timed = Timed::tick,
                .repetitions = 1,
                .threads = request_.threads};
        Stopwatch watch;
        Patience patience(longest);
        const auto told = [&](double share) {
            tell(name, share, watch.wall(), kind);
            patience.hear(share);
        };
        std::optional<Outcome> outcome = measure(job, request_.folders, stop_, told);
        if (outcome && outcome->missing.empty() && watch.wall() < quick) {
            job.repetitions = repetitions;
            outcome = measure(job, request_.folders, stop_, told);
        }
        if (!outcome) throw Stopped{};
        pace_.done(kind, watch.wall());
        begin_at_0(*outcome);
        return *std::move(outcome);
    }

    void tell(const std::string& name, double share, double spent, Pace::Kind kind) {
        if (!progress_) return;
        const double left = pace_.left(kind, share, spent), passed = watch_.wall();
        if (pace_.known()) shown_ = std::max(shown_, passed / (passed + left));    // a bar that falls back tells nothing
        progress_({.done = pace_.count_done(),
                   .all = pace_.count(),
                   .share = shown_,
                   .seconds_left = pace_.known() ? std::optional(left) : std::nullopt,
                   .name = name});
    }

    void weigh_all(const std::vector<Neighbour>& neighbours, bool other_models) {
        for (const Neighbour& neighbour : neighbours) weigh(neighbour, other_models);
    }

    void weigh(const Neighbour& neighbour, bool other_models) {
        Weighed weighed{.neighbour = neighbour, .other_models = other_models};
        Outcome outcome;
        const bool the_scene_itself = outcomes_.empty();
        try {
            outcome = measured(neighbour.name, neighbour.changes, the_scene_itself ? longest_reference : longest_setting,
                               other_models ? Pace::models : Pace::steps);
        } catch (const GivenUp& given_up) {
            outcome.missing = words_of(given_up);
        }
        if (!outcome.timing && !the_scene_itself) {    // refused, or given up
            advice_.left_out.push_back({neighbour.name, outcome.missing});
            return;
        }
        weighed.why = outcome.missing;
        weighed.timing = outcome.timing;
        weighed.remarks = outcome.remarks;
        advice_.settings.push_back(std::move(weighed));
        outcomes_.push_back(std::move(outcome));
    }

    void find_reference() {
        if (request_.reference) {
            const std::string name = with_changes("the scene", *request_.reference);
            take_reference(name, "as was asked", *request_.reference,
                           measured("the reference", *request_.reference, INFINITY, Pace::references));
        } else {
            look_for_reference();
        }
        if (!reference_.missing.empty())
            throw Error(fmt::format("the reference, {}: {}", advice_.reference.name, reference_.missing));
        if (advice_.reference.largest > 0.0) return;
        throw Error(fmt::format("{} is 0 all along in the reference, {}: there is nothing to compare", advice_.column,
                                advice_.reference.name));
    }

    void look_for_reference() {
        const std::size_t index = costliest(advice_.settings);
        const Neighbour& models = advice_.settings[index].neighbour;
        const std::string why = index == 0 ? "the scene's own models, none clearly costlier, taken for the truth"
                                           : "the costliest of the models, taken for the truth";
        const auto finest = finest_step(base_.read(models.changes), request_.folders);
        if (!finest.empty() && try_reference(models, why, finest)) return;
        take_reference(models.name, why, models.changes, outcomes_[index]);
    }

    /// False where it is refused, ends in a fault or takes too long.
    bool try_reference(const Neighbour& models, const std::string& why, const std::vector<core::Override>& finest) {
        const std::string name = with_changes(models.name, finest);
        const std::vector<core::Override> changes = joined(models.changes, finest);
        try {
            Outcome outcome = measured("the reference", changes, longest_reference, Pace::references);
            if (!outcome.missing.empty()) return false;
            take_reference(name, why, changes, std::move(outcome));
            return true;
        } catch (const GivenUp& given_up) {
            advice_.left_out.push_back({"reference: " + name, words_of(given_up)});
        } catch (const core::SceneErrors& errors) {
            advice_.left_out.push_back({"reference: " + name, errors.messages().front()});
        }
        return false;
    }

    void take_reference(const std::string& name, const std::string& why, const std::vector<core::Override>& changes,
                        Outcome outcome) {
        advice_.reference = {
            .name = name, .why = why, .changes = changes, .timing = outcome.timing, .largest = largest_of(outcome)};
        reference_ = std::move(outcome);
    }

    void compare() {
        for (std::size_t i = 0; i < outcomes_.size(); ++i) {
            Weighed& weighed = advice_.settings[i];
            const ErrorOfOutcome error = error_of(outcomes_[i], reference_);
            weighed.error = error.error;
            if (weighed.why.empty()) weighed.why = error.why;
        }
    }

    void leave_out() {
        const std::vector<core::Override>& chosen = advice_.settings[advice_.examined].neighbour.changes;
        const Outcome& with = outcomes_[advice_.examined];
        advice_.largest = largest_of(with);
        if (!with.missing.empty() || !with.timing) return;
        for (const Neighbour& omitted : omissions(base_.read(chosen), request_.folders)) {
            try {
                const Outcome without =
                    measured("without " + omitted.name, joined(chosen, omitted.changes), longest_setting, Pace::omissions);
                if (without.timing) advice_.omissions.push_back(omission_of(omitted, with, without));    // else it was refused
            } catch (const GivenUp& given_up) {
                advice_.omissions.push_back({.neighbour = omitted, .why = words_of(given_up)});
            } catch (const core::SceneErrors&) {
                continue;    // no effect, but what the scene cannot do without
            }
        }
    }

    const Request& request_;
    const ChangedScene base_;
    const core::Scene scene_;
    const std::atomic<bool>& stop_;
    const std::function<void(const Progress&)>& progress_;
    Stopwatch watch_;
    Pace pace_;
    double shown_ = 0.0;    // of all that is to be done
    Advice advice_;
    std::vector<Outcome> outcomes_;    // of the settings
    Outcome reference_;
};

}    // namespace

std::optional<Advice> advise(const Request& request, const std::atomic<bool>& stop,
                             const std::function<void(const Progress&)>& progress) {
    try {
        return Adviser(request, stop, progress).advise();
    } catch (const Stopped&) {
        return std::nullopt;
    }
}

}    // namespace stylet::study
