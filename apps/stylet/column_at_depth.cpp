#include "apps/stylet/column_at_depth.h"

#include "apps/study/inserted_column.h"
#include "core/scene/complaints.h"
#include "core/scene/reader.h"

#include <stylet/foundation_equation.h>

#include <fmt/format.h>

#include <algorithm>

namespace stylet::app {
namespace {

constexpr double rounding = 1e-9;    // of a length: sums and units written in decimals

[[noreturn]] void refuse(const core::Scene& scene, const std::string& sentence) {
    throw core::SceneErrors({fmt::format("{}: {}", scene.file.string(), sentence)});
}

}    // namespace

Column column_at_depth(const core::Scene& scene, double depth, const std::string& gave) {
    const NeedleSetup& needle = *scene.needle_setup;
    const double most = study::deepest(scene);
    if (!(depth >= 0.0 && depth <= most * (1.0 + rounding))) {
        const char* const why = !scene.tissue          ? "the scene has no tissue"
                                : most < needle.length ? "the tissue's height"
                                                       : "the needle's length";
        refuse(scene, fmt::format("--depth: found {}, wanted {} ({})", core::quote(gave),
                                  most > 0.0 ? fmt::format("0 m to {:g} m", most) : "0 m", why));
    }
    return study::inserted_column(scene, std::min(depth, most));
}

double equivalent_stiffness(const core::Scene& scene, const Column& column, double load) {
    if (column.ends != Ends::clamped_free)
        refuse(scene, "--stiffness: found other ends than clamped-free, wanted those: Eq. (3) is of such a column");
    if (column.free_length > rounding * column.length()) {
        refuse(scene, fmt::format("--stiffness: found {:g} m of needle in air, wanted a needle wholly in tissue "
                                  "(--depth '{:g} mm'): Eq. (3) knows no air",
                                  column.free_length, 1e3 * column.length()));
    }
    return foundation_stiffness(column.bending_stiffness, column.length(), load, FoundationForm::consistent);
}

}    // namespace stylet::app
