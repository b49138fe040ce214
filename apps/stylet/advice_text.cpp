#include "apps/stylet/advice_text.h"

#include "apps/study/fineness.h"
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

std::string paragraph(const std::string& text) {
    return wrapped(text, indent, page_width);
}

std::string yes_or_no(bool yes) {
    return yes ? "yes" : "no";
}

/// "1.000 N", "1.37 mm": of the compared curve.
std::string amount(double value, const std::string& unit) {
    if (unit == "m") return fmt::format("{:.4g} mm", 1e3 * value);
    return fmt::format("{:.4g} {}", value, unit);
}

// As they were asked for: a limit has no digits of its own.
std::string budget_text(const Advice& advice) {
    return study::written(advice.wish.budget, "s");
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
    return advice.title + "\n" + fact("scene", advice.scene.string()) +
           fact("error", fmt::format("RMS of {} over time, as a share of its largest, {}", advice.column,
                                     amount(reference.largest, advice.unit))) +
           fact("reference", fmt::format("{} ({}--reference KEY=VALUE chooses another)", reference.name, cost)) +
           fact("timed", fmt::format("every tick, {} thread{}", advice.threads, advice.threads == 1 ? "" : "s")) +
           fact("machine", machine_text(advice.machine)) + "\n";
}

std::string remarks_of(const Weighed& setting) {
    std::vector<std::string> all = setting.remarks;
    if (!setting.why.empty()) all.insert(all.begin(), setting.why);
    if (!setting.same_rate()) all.emplace_back("not to be taken: the rate is the hand's");
    if (setting.timing && setting.timing->contended) all.emplace_back("timed on a busy machine");
    return fmt::format("{}", fmt::join(all, "; "));
}

std::string settings_text(const Advice& advice) {
    Table table({Align::left, Align::right, Align::right, Align::right, Align::right, Align::right, Align::left});
    table.add({"setting", "error", "a tick", "p99", "in " + budget_text(advice), "under " + limit_text(advice), ""});
    bool of_models = true;
    for (const Weighed& setting : advice.settings) {
        if (of_models && !setting.other_models) table.add({"the scene with"});
        of_models = setting.other_models;
        const bool first = &setting == &advice.settings.front();
        table.add({(of_models ? "" : "  ") + setting.neighbour.name + (first ? " (the scene)" : ""), error_text(setting.error),
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
std::string pointing(const std::string& sentence, const Weighed& setting) {
    const std::string words = set_words(setting.neighbour.changes);
    const std::string text =
        paragraph(fmt::format("{} {}{}: {} off, {} a tick, 99 of 100 ticks within {}.", sentence, setting.neighbour.name,
                              words.empty() ? " (the scene as it is)" : "", error_text(setting.error),
                              time_text(setting.timing->median), time_text(setting.timing->p99)));
    const std::string mind = setting.remarks.empty() ? "" : paragraph(fmt::format("Mind: {}.", fmt::join(setting.remarks, "; ")));
    return text + (words.empty() ? "" : std::string(indent + 4, ' ') + words + "\n") + mind;
}

std::string verdict(const Advice& advice) {
    const std::string in_time = "within " + budget_text(advice), near_enough = "under " + limit_text(advice);
    std::string text;
    if (advice.take) {
        text += pointing("Take", advice.settings[*advice.take]);
        text += paragraph(fmt::format(
            "None {} is nearer by more than {}{}.", in_time, error_text(advice.wish.idle_error()),
            advice.cheapest == advice.take ? fmt::format(", none {} is cheaper by more than a tenth", near_enough) : ""));
    } else {
        text += paragraph(fmt::format("No setting is both {} and {}. Each step was taken alone: --set one and ask again.",
                                      in_time, near_enough));
        if (advice.nearest) text += pointing(fmt::format("The most accurate {} is", in_time), advice.settings[*advice.nearest]);
    }
    if (advice.cheapest && advice.cheapest != advice.take)
        text += pointing(fmt::format("The cheapest {} is", near_enough), advice.settings[*advice.cheapest]);
    return text;
}

/// What it adds to a tick; what is lost in the noise of a clock is none.
std::string cost_text(const Omission& omission, double tick) {
    constexpr double noise = 0.03;    // of the tick
    if (std::abs(omission.saved) < noise * tick) return fmt::format("under {:.0f} %", 100.0 * noise);
    return fmt::format("{}{} ({:+.0f} %)", omission.saved < 0.0 ? "-" : "", time_text(std::abs(omission.saved)),
                       100.0 * omission.saved / tick);
}

std::string omissions_text(const Advice& advice) {
    const Weighed& examined = advice.settings[advice.examined];
    if (advice.omissions.empty() || !examined.timing) return "";
    const double tick = examined.timing->median;
    Table table({Align::left, Align::right, Align::right, Align::right, Align::left});
    table.add({"effect", "costs a tick", "changes " + advice.column, "largest without it", ""});
    for (const Omission& omission : advice.omissions) {
        if (omission.why.empty()) {
            table.add({omission.neighbour.name, cost_text(omission, tick), error_text(omission.change),
                       amount(omission.largest, advice.unit)});
        } else {
            table.add({omission.neighbour.name, "", "", "", omission.why});
        }
    }
    return "\n" +
           paragraph(
               fmt::format("What each effect costs and does, in {}: found by leaving it out. A tick takes {}, {} is at most "
                           "{}; changes are RMS over time, as a share of that.",
                           examined.neighbour.name, time_text(tick), advice.column, amount(advice.largest, advice.unit))) +
           "\n" + table.text(indent);
}

/// As a shell takes it.
std::string quoted(const std::string& word) {
    const auto plain = [](unsigned char c) {
        return std::isalnum(c) != 0 || std::string_view("._-=/:").find(static_cast<char>(c)) != std::string_view::npos;
    };
    if (std::all_of(word.begin(), word.end(), plain)) return word;
    return "'" + word + "'";
}

}    // namespace

std::string set_words(const std::vector<core::Override>& changes) {
    std::string words;
    for (const core::Override& change : changes)
        words += (words.empty() ? "" : " ") + std::string("--set ") + quoted(change.key + "=" + change.value);
    return words;
}

std::string advice_text(const Advice& advice) {
    return heading(advice) + settings_text(advice) + "\n" + left_out_text(advice) + (advice.left_out.empty() ? "" : "\n") +
           verdict(advice) + omissions_text(advice);
}

}    // namespace stylet::app
