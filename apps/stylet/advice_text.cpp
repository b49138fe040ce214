#include "apps/stylet/advice_text.h"

#include "apps/study/fineness.h"
#include "apps/stylet/shell_word.h"
#include "apps/stylet/study_words.h"
#include "apps/stylet/table.h"

#include <fmt/format.h>

#include <cmath>

namespace stylet::app {
namespace {

using study::Advice;
using study::Omission;
using study::Weighed;
using Align = Table::Align;

constexpr std::size_t indent = 2, page_width = 120;    // [characters]

std::string set_words(const std::vector<core::Override>& changes) {
    std::string words;
    for (const core::Override& change : changes) words += " --set " + shell_word(change.key + "=" + change.value);
    return words;
}

std::string paragraph(const std::string& text) {
    return wrapped(text, indent, page_width);
}

std::string yes_or_no(bool yes) {
    return yes ? "yes" : "no";
}

/// Of an error or a change: beyond ten times the curve itself digits say nothing.
std::string share_text(double share) {
    constexpr double most = 10.0;
    return std::isfinite(share) && share > most ? fmt::format("> {:.0f} %", 100.0 * most) : error_text(share);
}

/// "1.000 N", "1.37 mm": of the compared curve.
std::string amount(double value, const std::string& unit) {
    if (unit == "m") return fmt::format("{:.4g} mm", 1e3 * value);
    return fmt::format("{:.4g} {}", value, unit);
}

// As they were asked for: a limit has no digits of its own.
std::string budget_text(const Advice& advice) {
    std::string text = study::written(advice.wish.budget, "s");
    if (text.ends_with(" us")) text.replace(text.size() - 2, 1, "µ");
    return text;
}
std::string limit_text(const Advice& advice) {
    return fmt::format("{:g} %", 100.0 * advice.wish.error);
}

/// A fact's name, and what may be too long for a line.
std::string fact(const std::string& name, const std::string& text) {
    constexpr std::size_t names = 12;    // [characters] that the longest takes, and what parts it from its text
    return std::string(indent, ' ') + name + std::string(names - name.size(), ' ') +
           wrapped(text, indent + names, page_width).substr(indent + names);
}

std::string heading(const Advice& advice) {
    const study::ReferenceSetting& reference = advice.reference;
    const std::string cost = reference.timing ? time_text(reference.timing->median) + " a tick; " : "";
    std::string mind;
    for (const std::string& sentence : advice.mind) mind += fact("mind", sentence);
    return advice.title + "\n" + fact("scene", advice.scene.string() + set_words(advice.changes)) +
           fact("error", fmt::format("RMS of {} over time, as a share of its largest, {}", advice.column,
                                     amount(reference.largest, advice.unit))) +
           fact("reference",
                fmt::format("{} ({}{}; --reference KEY=VALUE chooses another)", reference.name, cost, reference.why)) +
           fact("timed", fmt::format("every tick, {} thread{}", advice.threads, advice.threads == 1 ? "" : "s")) +
           fact("machine", machine_text(advice.machine)) + mind + "\n";
}

std::string remarks_of(const Weighed& setting) {
    std::vector<std::string> all = setting.remarks;
    if (!setting.why.empty()) all.insert(all.begin(), setting.why);
    if (!setting.same_rate()) all.emplace_back("not to be taken: the rate is the hand's");
    if (setting.timing && setting.timing->contended) all.emplace_back("busy machine: judged by the median");
    return fmt::format("{}", fmt::join(all, "; "));
}

std::string settings_text(const Advice& advice) {
    Table table({Align::left, Align::right, Align::right, Align::right, Align::right, Align::right, Align::left});
    table.add({"setting", "error", "a tick", "p99", "p99 in " + budget_text(advice), "under " + limit_text(advice), ""});
    bool of_models = true;
    for (const Weighed& setting : advice.settings) {
        if (of_models && !setting.other_models) table.add({"the scene with"});
        of_models = setting.other_models;
        const bool first = &setting == &advice.settings.front();
        table.add({(of_models ? "" : "  ") + setting.neighbour.name + (first ? " (the scene)" : ""), share_text(setting.error),
                   setting.timing ? time_text(setting.timing->median) : "", setting.timing ? time_text(setting.timing->p99) : "",
                   yes_or_no(setting.in_time(advice.wish)), yes_or_no(setting.near_enough(advice.wish)), remarks_of(setting)});
    }
    return table.text(indent);
}

std::string left_out_text(const Advice& advice) {
    std::string text;
    for (const study::LeftOut& left_out : advice.left_out)
        text += paragraph(fmt::format("left out: {}: {}", left_out.name, left_out.why));
    return text;
}

/// A sentence that ends with the setting, and below it how to have it.
std::string pointing(const std::string& sentence, const Weighed& setting, const Advice& advice) {
    std::vector<core::Override> changes = advice.changes;
    changes.insert(changes.end(), setting.neighbour.changes.begin(), setting.neighbour.changes.end());
    const study::Timing& timing = *setting.timing;
    const std::string slow = timing.contended ? "by the median: the machine was busy"
                                              : fmt::format("99 of 100 ticks within {}", time_text(timing.p99));
    const std::string text = paragraph(fmt::format("{} {}{}: {} off, {} a tick, {}.", sentence, setting.neighbour.name,
                                                   setting.neighbour.changes.empty() ? " (the scene as it is)" : "",
                                                   share_text(setting.error), time_text(timing.median), slow));
    const std::string mind = setting.remarks.empty() ? "" : paragraph(fmt::format("Mind: {}.", fmt::join(setting.remarks, "; ")));
    return text + std::string(indent + 4, ' ') + run_command(advice.scene, changes) + "\n" + mind;
}

std::string verdict(const Advice& advice) {
    const std::string in_time = "within " + budget_text(advice), near_enough = "under " + limit_text(advice);
    std::string text;
    if (advice.take) {
        text += pointing("Take", advice.settings[*advice.take], advice);
        const std::string none_cheaper = fmt::format(", none {} is cheaper by more than a tenth", near_enough);
        text += paragraph(fmt::format("None {} is nearer by more than {:g} %{}.", in_time, 100.0 * advice.wish.idle_error(),
                                      advice.cheapest == advice.take ? none_cheaper : ""));
    } else {
        text += paragraph(fmt::format(
            "No setting is both {} and {}. Only one step was tried at a time: add one of them by --set, and ask again.", in_time,
            near_enough));
        if (advice.nearest)
            text += pointing(fmt::format("The most accurate {} is", in_time), advice.settings[*advice.nearest], advice);
    }
    if (advice.cheapest && advice.cheapest != advice.take)
        text += pointing(fmt::format("The cheapest {} is", near_enough), advice.settings[*advice.cheapest], advice);
    return text;
}

/// What it adds to a tick; what is lost in the noise of a clock is none.
std::string cost_text(const Omission& omission, double tick) {
    if (omission.other_run) return "the run is another one";
    if (!std::isfinite(omission.noise)) return "the machine was busy";
    if (std::abs(omission.cost) < omission.noise) return fmt::format("under {:.0f} %", std::ceil(100.0 * omission.noise / tick));
    return fmt::format("{}{} ({:+.0f} %)", omission.cost < 0.0 ? "-" : "", time_text(std::abs(omission.cost)),
                       100.0 * omission.cost / tick);
}

std::string change_text(const Omission& omission) {
    return omission.change < least_error ? "never came into play" : share_text(omission.change);
}

std::string omissions_text(const Advice& advice) {
    const Weighed& examined = advice.settings[advice.examined];
    if (advice.omissions.empty() || !examined.timing) return "";
    const double tick = examined.timing->mean;
    Table table({Align::left, Align::right, Align::right, Align::right, Align::left});
    table.add({"effect", "costs a tick", "changes " + advice.column, "largest without it", ""});
    for (const Omission& omission : advice.omissions) {
        if (omission.why.empty()) {
            table.add({omission.neighbour.name, cost_text(omission, tick), change_text(omission),
                       amount(omission.largest, advice.unit)});
        } else {
            table.add({omission.neighbour.name, "", "", "", omission.why});
        }
    }
    return "\n" +
           paragraph(fmt::format(
               "What each effect costs and does, in {}: found by leaving it out. A tick takes {} in the mean, {} is at most "
               "{}; changes are RMS over time, as a share of that.",
               examined.neighbour.name, time_text(tick), advice.column, amount(advice.largest, advice.unit))) +
           "\n" + table.text(indent);
}

}    // namespace

std::string run_command(const std::filesystem::path& scene, const std::vector<core::Override>& changes) {
    return "stylet run " + shell_word(scene.string()) + set_words(changes);
}

std::string advice_text(const Advice& advice) {
    return heading(advice) + settings_text(advice) + "\n" + left_out_text(advice) + (advice.left_out.empty() ? "" : "\n") +
           verdict(advice) + omissions_text(advice);
}

}    // namespace stylet::app
