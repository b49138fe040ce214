#include "apps/study/run_observer.h"

#include "core/scene/suggestion.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

namespace stylet::study {
namespace {

double core::Sample::*value_of(const std::string& name) {
    const core::Column* column = core::column_named(name);
    return column == nullptr ? nullptr : column->value;
}

/// What an event itself knows of its moment, which is before what it sets off; other columns are those of its tick's end.
double at_event(const core::Event& event, const core::Sample& sample, double core::Sample::*column) {
    if (column == &core::Sample::time) return event.time;
    if (column == &core::Sample::travel) return event.travel;
    if (column == &core::Sample::depth) return event.depth;
    if (column == &core::Sample::hand_force) return event.hand_force;
    return sample.*column;
}

/// "never punctred; did you mean 'punctured'?", of what did happen.
std::string never(const std::string& wanted, const core::RunReport& report) {
    std::vector<std::string> happened;
    for (const core::EventReport& event : report.events) happened.push_back(event.name);
    return fmt::format("never {}{}", wanted, core::suggestion(wanted, happened));
}

}    // namespace

RunObserver::RunObserver(const Measure& measure) : measure_(measure) {
    if (const auto* curve = std::get_if<CurveMeasure>(&measure)) {
        column_ = value_of(curve->column);
        over_ = value_of(curve->over);
    } else if (const auto* value = std::get_if<ValueMeasure>(&measure)) {
        column_ = value_of(value->value);
    } else if (const auto* event = std::get_if<EventMeasure>(&measure)) {
        column_ = value_of(event->column);
    }
}

void RunObserver::take(const core::Simulation& simulation) {
    if (const auto* curve = std::get_if<CurveMeasure>(&measure_)) {
        if (!curve->holds(simulation.sample().*over_)) return;
        outcome_.x.push_back(simulation.sample().*over_);
        outcome_.y.push_back(simulation.sample().*column_);
    } else if (std::holds_alternative<EventMeasure>(measure_) && outcome_.y.empty()) {
        take_event(simulation);
    }
}

void RunObserver::take_event(const core::Simulation& simulation) {
    const std::string& wanted = std::get<EventMeasure>(measure_).event;
    for (const core::Event& event : simulation.events()) {
        if (wanted != event.name) continue;
        outcome_.y = {at_event(event, simulation.sample(), column_)};
        return;
    }
}

double RunObserver::last_value(const core::RunReport& report) const {
    const std::string& value = std::get<ValueMeasure>(measure_).value;
    if (value == "peak_hand_force") return report.peak_hand_force;
    if (value == "largest_deflection") return report.largest_deflection;
    return report.ledger.totals.*column_;
}

Outcome RunObserver::finish(const core::RunReport& report) {
    if (std::holds_alternative<ValueMeasure>(measure_)) outcome_.y = {last_value(report)};
    if (const auto* event = std::get_if<EventMeasure>(&measure_); event != nullptr && outcome_.y.empty())
        outcome_.missing = never(event->event, report);
    outcome_.remarks = remarks_of(report);
    outcome_.punctured = std::ranges::find(report.events, "punctured", &core::EventReport::name) != report.events.end();
    const auto fault =
        std::ranges::find_if(report.events, [](const core::EventReport& event) { return event.name.starts_with("fault"); });
    if (fault != report.events.end()) outcome_.missing = fault->name;
    return std::move(outcome_);
}

std::vector<std::string> remarks_of(const core::RunReport& report) {
    std::vector<std::string> remarks;
    if (report.lost_ticks > 0)
        remarks.push_back(fmt::format("found no equilibrium in {} of {} ticks", report.lost_ticks, report.ticks));
    constexpr std::string_view beyond = "beyond validity: ";
    for (const core::EventReport& event : report.events) {
        if (!event.name.starts_with(beyond)) continue;
        const std::string words = event.name.substr(beyond.size());
        if (std::ranges::find(remarks, words) == remarks.end()) remarks.push_back(words);
    }
    return remarks;
}

}    // namespace stylet::study
