#include "apps/stylet/critical_loads.h"

#include "apps/stylet/gathered_errors.h"
#include "apps/stylet/scene_loads.h"
#include "core/scene/units.h"

#include <algorithm>

namespace stylet::app {

const LoadCurve* SceneLoads::curve(const std::string& model) const {
    const auto found = std::ranges::find(curves, model, &LoadCurve::model);
    return found == curves.end() ? nullptr : &*found;
}

std::vector<std::string> CriticalLoads::models() const {
    std::vector<std::string> models;
    for (const SceneLoads& scene : scenes) {
        for (const LoadCurve& curve : scene.curves) {
            if (std::ranges::find(models, curve.model) == models.end()) models.push_back(curve.model);
        }
    }
    return models;
}

bool CriticalLoads::one_point() const {
    return std::ranges::all_of(scenes, [](const SceneLoads& scene) { return scene.points.size() == 1; });
}

CriticalLoads critical_loads(const LoadQuestion& question) {
    CriticalLoads loads{.axis = "depth", .unit = "mm", .along_depth = !question.varied, .scenes = {}};
    if (question.varied) {
        loads.axis = question.varied->key;
        loads.unit = question.varied->values.unit;
        if (question.depth) loads.depth = core::read_quantity(question.depth->text, "m").value;
    } else if (question.depth) {
        loads.unit = question.depth->unit;
    }
    GatheredErrors errors;
    for (const std::string& file : question.scenes) errors.gather([&] { loads.scenes.push_back(scene_loads(question, file)); });
    errors.throw_if_any();
    return loads;
}

}    // namespace stylet::app
