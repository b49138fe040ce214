#include "apps/study/advice.h"

#include <algorithm>
#include <cmath>

namespace stylet::study {
namespace {

bool may_be_taken(const Weighed& setting) {
    return setting.timing && std::isfinite(setting.error) && setting.same_rate();
}

/// The first setting of those that `fit` whose `cost` is no more than the least of them and what does not count of that.
template <class Fit, class Cost, class Alike>
std::optional<std::size_t> least(const std::vector<Weighed>& settings, Fit&& fit, Cost&& cost, Alike&& alike) {
    double least = std::numeric_limits<double>::infinity();
    const auto takes_part = [&](const Weighed& setting) { return may_be_taken(setting) && fit(setting); };
    for (const Weighed& setting : settings) {
        if (takes_part(setting)) least = std::min(least, cost(setting));
    }
    for (std::size_t i = 0; i < settings.size(); ++i) {
        if (takes_part(settings[i]) && cost(settings[i]) <= alike(least)) return i;
    }
    return std::nullopt;
}

}    // namespace

bool Weighed::in_time(const Wish& wish) const {
    constexpr double us = 1e6;    // in a second
    return timing && (timing->contended ? timing->median : timing->p99) <= wish.budget * us;
}

bool Weighed::same_rate() const {
    return std::ranges::none_of(neighbour.changes, [](const core::Override& change) { return change.key == "run.rate"; });
}

std::size_t costliest(const std::vector<Weighed>& settings) {
    constexpr double clearly = 2.0;    // as long
    const auto time = [](const Weighed& setting) {
        return setting.why.empty() && setting.timing ? setting.timing->median : -1.0;
    };
    double most = 0.0;
    for (const Weighed& setting : settings) most = std::max(most, time(setting));
    const auto first = std::ranges::find_if(settings, [&](const Weighed& setting) { return clearly * time(setting) > most; });
    return first == settings.end() ? 0 : static_cast<std::size_t>(first - settings.begin());
}

void choose(Advice& advice) {
    const Wish& wish = advice.wish;
    const auto in_time = [&](const Weighed& setting) { return setting.in_time(wish); };
    const auto near_enough = [&](const Weighed& setting) { return setting.near_enough(wish); };
    const auto both = [&](const Weighed& setting) { return in_time(setting) && near_enough(setting); };
    const auto error = [](const Weighed& setting) { return setting.error; };
    const auto time = [](const Weighed& setting) { return setting.timing->median; };
    const auto as_near = [&](double least) { return least + wish.idle_error(); };
    const auto as_cheap = [](double least) { return (1.0 + Wish::idle) * least; };
    advice.take = least(advice.settings, both, error, as_near);
    advice.nearest = least(advice.settings, in_time, error, as_near);
    advice.cheapest = least(advice.settings, near_enough, time, as_cheap);
    advice.examined = advice.take.value_or(0);
}

}    // namespace stylet::study
