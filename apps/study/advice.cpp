#include "apps/study/advice.h"

#include <algorithm>
#include <cmath>

namespace stylet::study {
namespace {

/// The setting of those that `fit` with the least `cost`, the earlier of two alike.
template <class Fit, class Cost>
std::optional<std::size_t> least(const std::vector<Weighed>& settings, Fit&& fit, Cost&& cost) {
    std::optional<std::size_t> best;
    for (std::size_t i = 0; i < settings.size(); ++i) {
        if (!settings[i].timing || !std::isfinite(settings[i].error) || !settings[i].same_rate() || !fit(settings[i])) continue;
        if (!best || cost(settings[i]) < cost(settings[*best])) best = i;
    }
    return best;
}

}    // namespace

bool Weighed::in_time(const Wish& wish) const {
    constexpr double us = 1e6;    // in a second
    return timing && timing->p99 <= wish.budget * us;
}

bool Weighed::same_rate() const {
    return std::ranges::none_of(neighbour.changes, [](const core::Override& change) { return change.key == "run.rate"; });
}

void choose(Advice& advice) {
    const Wish& wish = advice.wish;
    const auto in_time = [&](const Weighed& setting) { return setting.in_time(wish); };
    const auto near_enough = [&](const Weighed& setting) { return setting.near_enough(wish); };
    const auto error = [](const Weighed& setting) { return setting.error; };
    const auto time = [](const Weighed& setting) { return setting.timing->median; };
    advice.nearest = least(advice.settings, in_time, error);
    advice.cheapest = least(advice.settings, near_enough, time);
    const bool both = advice.nearest && near_enough(advice.settings[*advice.nearest]);
    advice.take = both ? advice.nearest : std::nullopt;
    advice.examined = advice.take.value_or(0);
}

}    // namespace stylet::study
