// What a study takes from a run, tick by tick.
#pragma once

#include "apps/study/outcome.h"
#include "core/run/report.h"
#include "core/run/simulation.h"

namespace stylet::study {

/// Collects a measure from the ticks of one run.
class RunObserver {
public:
    explicit RunObserver(const Measure& measure);

    void take(const core::Simulation& simulation);

    /// Once, when the run is over.
    [[nodiscard]] Outcome finish(const core::RunReport& report);

private:
    void take_event(const core::Simulation& simulation);
    [[nodiscard]] double last_value(const core::RunReport& report) const;

    const Measure& measure_;
    double core::Sample::*column_ = nullptr;
    double core::Sample::*over_ = nullptr;
    Outcome outcome_;
};

/// What the report says that a reader should know of: a fault, ticks without an equilibrium, a model beyond its validity.
[[nodiscard]] std::vector<std::string> remarks_of(const core::RunReport& report);

}    // namespace stylet::study
