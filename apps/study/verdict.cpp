#include "apps/study/verdict.h"

#include "apps/study/readable.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace stylet::study {
namespace {

constexpr std::array limits{0.01, 0.05};    // relative; the second is about what a hand can tell
constexpr double in_time = 1000.0;          // [µs] the period of a haptic loop

using Settings = std::vector<const SettingResult*>;

double error_of(const SettingResult* setting) {
    return setting->error.judged;
}
double time_of(const SettingResult* setting) {
    return setting->timing->median;
}

/// Those with an error to compare, and a time where something was timed.
Settings comparable(const Result& result) {
    Settings settings;
    for (const SettingResult& setting : result.settings) {
        const bool has_time = result.timed == Timed::nothing || setting.timing;
        if (std::isfinite(setting.error.judged) && !setting.is_reference && has_time) settings.push_back(&setting);
    }
    return settings;
}

template <class Fits>
Settings those(const Settings& settings, const Fits& fits) {
    Settings fitting;
    std::ranges::copy_if(settings, std::back_inserter(fitting), fits);
    return fitting;
}

Settings under(const Settings& settings, double limit) {
    return those(settings, [limit](const SettingResult* setting) { return error_of(setting) < limit; });
}

const SettingResult& nearest(const Settings& settings) {
    return **std::ranges::min_element(settings, {}, error_of);
}
const SettingResult& cheapest(const Settings& settings) {
    return **std::ranges::min_element(settings, {}, time_of);
}
const SettingResult& coarsest(const Settings& settings) {
    return **std::ranges::max_element(settings, {}, error_of);
}

std::string percent(double limit) {
    return fmt::format("{:g} %", 100.0 * limit);
}

/// "38.0 µs a tick"
std::string cost(const SettingResult& setting, Timed timed) {
    const std::string busy = setting.timing->contended ? " (on a busy machine)" : "";
    return fmt::format("{} {}{}", time_text(setting.timing->median), each(timed), busy);
}

/// "rod, 21 nodes: 0.42 % at 38.0 µs a tick"
std::string figures(const SettingResult& setting, Timed timed) {
    const std::string at = timed == Timed::nothing ? "" : " at " + cost(setting, timed);
    return fmt::format("{}: {}{}", setting.name(), error_text(setting.error.judged), at);
}

bool dominates(const SettingResult* one, const SettingResult* other) {
    const bool no_worse = time_of(one) <= time_of(other) && error_of(one) <= error_of(other);
    return no_worse && (time_of(one) < time_of(other) || error_of(one) < error_of(other));
}

void mark_front(Result& result) {
    const Settings settings = result.timed == Timed::nothing ? Settings{} : comparable(result);
    for (SettingResult& setting : result.settings) {
        const auto beats = [&](const SettingResult* other) {
            return (!result.own_references || other->series == setting.series) && dominates(other, &setting);
        };
        setting.on_front = std::ranges::count(settings, &setting) == 1 && std::ranges::none_of(settings, beats);
    }
}

/// The cheapest under each limit; one sentence where it is the same.
std::vector<std::string> cheapest_under(const Settings& settings, Timed timed) {
    const Settings close = under(settings, limits[0]), fair = under(settings, limits[1]);
    const std::string off = fmt::format("the nearest is {}.", figures(nearest(settings), timed));
    if (fair.empty()) return {fmt::format("None is under {}: {}", percent(limits[1]), off)};
    if (!close.empty() && &cheapest(close) == &cheapest(fair)) {
        return {fmt::format("Cheapest under {}, and under {}: {}.", percent(limits[0]), percent(limits[1]),
                            figures(cheapest(close), timed))};
    }
    return {close.empty() ? fmt::format("None is under {}: {}", percent(limits[0]), off)
                          : fmt::format("Cheapest under {}: {}.", percent(limits[0]), figures(cheapest(close), timed)),
            fmt::format("Cheapest under {}: {}.", percent(limits[1]), figures(cheapest(fair), timed))};
}

/// Loading isn't done within a tick: there the limit says nothing.
std::string most_accurate(const Settings& settings, Timed timed) {
    if (timed == Timed::load) return fmt::format("Most accurate: {}.", figures(nearest(settings), timed));
    const Settings quick = those(settings, [](const SettingResult* setting) { return time_of(setting) <= in_time; });
    if (quick.empty())
        return fmt::format("None is within 1 ms {}: the cheapest is {}.", each(timed), figures(cheapest(settings), timed));
    const SettingResult& best = nearest(quick);
    const std::string late = best.timing->p99 <= in_time ? ""
                                                         : fmt::format(", but one {} in a hundred takes longer than {}",
                                                                       word_of(timed), time_text(best.timing->p99));
    return fmt::format("Most accurate within 1 ms {}: {}{}.", each(timed), figures(best, timed), late);
}

/// Where nothing was timed.
std::vector<std::string> counts(const Settings& settings) {
    std::vector<std::string> sentences;
    for (const double limit : limits) {
        const Settings fitting = under(settings, limit);
        if (fitting.empty()) continue;
        sentences.push_back(fmt::format("Under {}: {} of {}, the coarsest of them {}.", percent(limit), fitting.size(),
                                        settings.size(), figures(coarsest(fitting), Timed::nothing)));
    }
    const std::string none = sentences.empty() ? fmt::format("None is under {}. ", percent(limits.back())) : "";
    sentences.push_back(none + fmt::format("Most accurate: {}.", figures(nearest(settings), Timed::nothing)));
    return sentences;
}

std::string left_out(const SettingResult& setting, Timed timed) {
    const std::string costs = setting.timing ? fmt::format(" (it costs {})", cost(setting, timed)) : "";
    return fmt::format("{} is the reference itself and takes no part here{}.", setting.name(), costs);
}

std::vector<std::string> sentences_of(const Settings& settings, Timed timed) {
    if (timed == Timed::nothing) return counts(settings);
    std::vector<std::string> sentences = cheapest_under(settings, timed);
    sentences.push_back(most_accurate(settings, timed));
    return sentences;
}

/// The settings of each series, in the order of the series.
std::vector<Settings> by_series(const Settings& settings) {
    std::vector<Settings> series;
    for (const SettingResult* setting : settings) {
        if (series.empty() || series.back().front()->series != setting->series) series.emplace_back();
        series.back().push_back(setting);
    }
    return series;
}

std::vector<std::string> sentences_of(const Result& result) {
    const Settings settings = comparable(result);
    std::vector<std::string> sentences;
    if (settings.empty()) sentences.emplace_back("No setting has an error to compare.");
    for (const Settings& some : result.own_references ? by_series(settings) : std::vector<Settings>{settings}) {
        if (!some.empty()) std::ranges::copy(sentences_of(some, result.timed), std::back_inserter(sentences));
    }
    for (const SettingResult& setting : result.settings) {
        if (setting.is_reference) sentences.push_back(left_out(setting, result.timed));
    }
    return sentences;
}

}    // namespace

void add_verdict(Result& result) {
    mark_front(result);
    result.verdict = sentences_of(result);
}

}    // namespace stylet::study
