#pragma once

#include "core/export/pvd_series.h"
#include "core/export/tissue_grid.h"

#include <optional>

namespace stylet::core {

/// A run as pictures for other tools: NAME_tissue.pvd, NAME_needle.pvd and NAME_contacts.pvd with their files, each only where
/// the scene has what it shows.
class SceneSeries {
public:
    /// Of `rate` [Hz] > 0 pictures a second of simulated time, so far as whole ticks allow: the nearest number of ticks, at least
    /// one, lies between two. `folder` must be there. Throws Error where it cannot be written.
    SceneSeries(const Scene& scene, const std::filesystem::path& folder, const std::string& name, double rate);

    /// To be called as the simulation begins and after every tick. Throws Error where the disk is full.
    void observe(const Simulation& simulation);

    [[nodiscard]] double period() const { return static_cast<double>(every_) * scene_.run.dt(); }    // [s] between pictures
    [[nodiscard]] int moments() const { return moments_; }
    [[nodiscard]] std::vector<std::filesystem::path> files() const;    // PVD

private:
    const Scene& scene_;
    std::size_t every_;    // [ticks]
    std::size_t calls_ = 0;
    int moments_ = 0;
    std::optional<TissueGrid> tissue_grid_;    // once the simulation has begun
    std::optional<PvdSeries> tissue_, needle_, contacts_;
};

}    // namespace stylet::core
