#pragma once

#include "core/loading/cast.h"
#include "core/run/report.h"
#include "core/run/simulation.h"

namespace stylet::core {

/// Notes from tick to tick what the loaded patches of the surface do. All memory is set aside when it is made: it may be filled
/// from the tick's thread. Where nothing is loaded it notes nothing.
class PatchRecord {
public:
    static constexpr std::size_t most_noted = 1'000'000;    // ticks: 48 MB for each patch

    /// Of a run of so many ticks; those beyond `most_noted` are not noted.
    PatchRecord(const Scene& scene, const Cast& cast, std::size_t ticks);

    /// After a tick. Neither allocates nor locks.
    void take(const Simulation& simulation);

    [[nodiscard]] const PatchReport& report() const { return report_; }

private:
    PatchReport report_;
};

}    // namespace stylet::core
