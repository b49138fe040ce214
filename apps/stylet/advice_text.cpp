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

std::string heading(const Advice& advice) {
    Table facts({Align::left, Align::left});
    facts.add({"scene", advice.scene.string()});
    facts.add({"error", fmt::format("RMS of {} over time, as a share of its largest, {}", advice.column,
                                    amount(advice.reference.largest, advice.unit))});
    facts.add({"reference", advice.reference.name});
    const std::string cost = advice.reference.timing ? time_text(advice.reference.timing->median) + " a tick; " : "";
    facts.add({"", cost + "--reference KEY=VALUE chooses another"});
    facts.add({"timed", fmt::format("every tick, {} thread{}", advice.threads, advice.threads == 1 ? "" : "s")});
    facts.add({"machine", machine_text(advice.machine)});
    return advice.title + "\n" + facts.text(indent) + "\n";
}

std::string remarks_of(const Weighed& setting) {
    std::string all = setting.why;
    for (const std::string& remark : setting.remarks) all += (all.empty() ? "" : "; ") + remark;
    if (setting.timing && setting.timing->contended) all += (all.empty() ? "" : "; ") + std::string("timed on a busy machine");
    return all;
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

/// "half_space, rod: 1.2 % off, 99 of 100 ticks within 62 µs"
std::string described(const Weighed& setting) {
    return fmt::format("{} ({} off, 99 of 100 ticks within {})", setting.neighbour.name, error_text(setting.error),
                       time_text(setting.timing->p99));
}

std::string how_to_take(const Weighed& setting) {
    if (setting.neighbour.changes.empty()) return "the scene as it is: ";
    return "";
}

std::string words_below(const Weighed& setting) {
    const std::string words = set_words(setting.neighbour.changes);
    return words.empty() ? "" : std::string(indent + 4, ' ') + words + "\n";
}

std::string verdict(const Advice& advice) {
    const auto setting = [&](const std::optional<std::size_t>& index) -> const Weighed& { return advice.settings[*index]; };
    const std::string limits = fmt::format("within {} and under {}", budget_text(advice), limit_text(advice));
    if (advice.take) {
        const Weighed& take = setting(advice.take);
        std::string text =
            paragraph(fmt::format("Take {}{}: the most accurate {}.", how_to_take(take), described(take), limits)) +
            words_below(take);
        if (advice.cheapest == advice.take) return text + paragraph("It is the cheapest of these, too.");
        const Weighed& cheapest = setting(advice.cheapest);
        return text +
               paragraph(fmt::format("The cheapest under {}: {}{}, {} a tick.", limit_text(advice), how_to_take(cheapest),
                                     described(cheapest), time_text(cheapest.timing->median))) +
               words_below(cheapest);
    }
    std::string text = paragraph(fmt::format("No setting is {}.", limits));
    if (advice.nearest) {
        text += paragraph(fmt::format("The most accurate within {}: {}{}.", budget_text(advice),
                                      how_to_take(setting(advice.nearest)), described(setting(advice.nearest)))) +
                words_below(setting(advice.nearest));
    }
    if (advice.cheapest) {
        text += paragraph(fmt::format("The cheapest under {}: {}{}.", limit_text(advice), how_to_take(setting(advice.cheapest)),
                                      described(setting(advice.cheapest)))) +
                words_below(setting(advice.cheapest));
    }
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
