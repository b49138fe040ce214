#include "apps/study/inserted_column.h"

#include <algorithm>

namespace stylet::study {

double deepest(const core::Scene& scene) {
    if (!scene.tissue_setup) return 0.0;
    return std::min(scene.needle_setup->length, scene.tissue_setup->extent.z());
}

Column inserted_column(const core::Scene& scene, double inserted) {
    const NeedleSetup& needle = *scene.needle_setup;
    return {.bending_stiffness = needle.bending_stiffness(),
            .free_length = needle.length - inserted,
            .inserted = inserted,
            .depth = inserted,
            .radius = needle.radius,
            .ends = needle.ends};
}

}    // namespace stylet::study
