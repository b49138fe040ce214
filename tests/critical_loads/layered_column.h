#pragma once

#include <stylet/contract/plugin.h>

#include <cmath>
#include <string>
#include <vector>

namespace stylet {

struct Bed {
    double thickness;    // [m]
    double modulus;      // [Pa] k
};

/// The paper's needle as a column on beds of known foundation modulus, below a part in air.
struct LayeredColumn {
    std::vector<Bed> beds;       // from the surface down, all of them crossed
    double free_length = 0.0;    // [m]
    Ends ends = Ends::clamped_free;

    static constexpr double radius = 0.3e-3;           // [m]
    static constexpr double youngs_modulus = 200e9;    // [Pa]

    [[nodiscard]] static NeedleSetup needle(double length, Ends ends) {
        return {.length = length, .radius = radius, .youngs_modulus = youngs_modulus, .ends = ends};
    }
    [[nodiscard]] static double bending_stiffness() { return needle(1.0, Ends::clamped_free).bending_stiffness(); }    // [N·m²]

    [[nodiscard]] double inserted() const {    // [m]
        double sum = 0.0;
        for (const Bed& bed : beds) sum += bed.thickness;
        return sum;
    }
    [[nodiscard]] double length() const { return free_length + inserted(); }    // [m]

    [[nodiscard]] Column column() const {
        return {.bending_stiffness = bending_stiffness(),
                .free_length = free_length,
                .inserted = inserted(),
                .depth = inserted(),
                .radius = radius,
                .ends = ends};
    }

    /// A scene's tissue, needle and parameters that say the same.
    [[nodiscard]] contract::Case with(contract::Given parameters) const {
        contract::Case with{.parameters = std::move(parameters), .needle = needle(length(), ends)};
        with.tissue.layers.clear();
        Parameters::Records given;
        for (const Bed& bed : beds) {
            const std::string name = "layer " + std::to_string(given.size() + 1);
            with.tissue.layers.push_back(
                {.name = name, .youngs_modulus = 1.0, .poisson_ratio = 0.3, .density = 1000.0, .thickness = bed.thickness});
            given.push_back(contract::Given{{"layer", name}, {"modulus", bed.modulus}});
        }
        with.parameters.set("foundation_modulus", std::string("given"));
        with.parameters.set("given", given);
        return with;
    }

    /// [N] by the buckling model of this name, with its further parameters.
    [[nodiscard]] double load(const std::string& model, const contract::Given& parameters = {}) const {
        const contract::Case scene = with(parameters);
        return contract::make<BucklingModel>(PLUGIN_FOLDER "/" + model + ".so", scene)->critical_load(column());
    }
};

/// A homogeneous column of length l [m] whose l (k/EI)^¼ is this.
inline LayeredColumn homogeneous(double slenderness, Ends ends = Ends::clamped_free, double length = 0.05) {
    const double modulus = LayeredColumn::bending_stiffness() * std::pow(slenderness / length, 4);    // [Pa]
    return {.beds = {{length, modulus}}, .ends = ends};
}

}    // namespace stylet
