#include "core/export/scene_series.h"

#include "core/export/body_grids.h"

#include <algorithm>
#include <cmath>

namespace stylet::core {

namespace {

std::size_t whole_ticks(double ticks) {
    constexpr double most = 1e15;    // more than any run has
    return static_cast<std::size_t>(std::clamp(std::round(ticks), 1.0, most));
}

}    // namespace

SceneSeries::SceneSeries(const Scene& scene, const std::filesystem::path& folder, const std::string& name, double rate)
    : scene_(scene), every_(whole_ticks(scene.run.rate / rate)) {
    if (scene.tissue) tissue_.emplace(folder, name + "_tissue");
    if (scene.needle) needle_.emplace(folder, name + "_needle");
    if (scene.tissue && scene.needle) contacts_.emplace(folder, name + "_contacts");
}

void SceneSeries::observe(const Simulation& simulation) {
    if (tissue_ && !tissue_grid_) tissue_grid_.emplace(scene_, simulation);
    if (calls_++ % every_ != 0) return;
    if (tissue_) tissue_->add(simulation.time(), tissue_grid_->at_present(simulation));
    if (needle_) needle_->add(simulation.time(), needle_grid(scene_, simulation));
    if (contacts_) contacts_->add(simulation.time(), contact_grid(scene_, simulation));
    ++moments_;
}

std::vector<std::filesystem::path> SceneSeries::files() const {
    std::vector<std::filesystem::path> files;
    for (const auto* series : {&tissue_, &needle_, &contacts_}) {
        if (*series) files.push_back((*series)->file());
    }
    return files;
}

}    // namespace stylet::core
