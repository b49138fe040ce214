#include "core/run/patch_record.h"

#include <algorithm>

namespace stylet::core {

PatchRecord::PatchRecord(const Scene& scene, const Cast& cast, std::size_t ticks) {
    const std::size_t most_ticks = std::min(ticks, most_noted);
    for (std::size_t i = 0; i < cast.effects().size(); ++i) {
        const Patch* patch = cast.effects()[i]->patch();
        if (patch == nullptr) continue;
        LoadedPatch& loaded = report_.patches.emplace_back();
        loaded.effect = scene.effects[i].path;
        loaded.patch = *patch;
        loaded.force.reserve(most_ticks);
        loaded.displacement.reserve(most_ticks);
    }
    if (!report_.patches.empty()) report_.times.reserve(most_ticks);
}

void PatchRecord::take(const Simulation& simulation) {
    if (report_.times.size() == report_.times.capacity()) return;
    report_.times.push_back(simulation.time());
    for (int i = 0; i < simulation.loads().count(); ++i) {
        report_.patches[i].force.push_back(simulation.loads().force(i));
        report_.patches[i].displacement.push_back(simulation.loads().displacement(i));
    }
}

}    // namespace stylet::core
