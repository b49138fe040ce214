#pragma once

#include <stylet/force_model.h>

#include <optional>

namespace stylet::fracture {

/// Fracture at the tip in two stages: deformation until the tissue ruptures, then penetration that costs fracture energy.
///
///     outside: the tip carries up to F_r;   inside: it carries up to F_c = 2πr·J_c and cuts at it;   energy of a cut Δl:
///     2πr·J_c·Δl
///
/// Source: He, Chen and Tang, section III, the fracture term of Eq. (7); Gokgol, Basdogan and Canadinc 2012 for J_c = 164 ± 6
/// J/m² of bovine liver. Deviation: Eq. (7) gives a force from the energy balance; here the same energy enters as the limit of
/// the tip's contact force, and the core's ledger closes the balance. Valid for a sharp tip whose crack is as long as the
/// needle's circumference. Leaves out rate dependence, the shape of the tip, and a rupture force of the layers below the surface.
/// Does no positive work: the tip's force is only bounded, and a cut consumes 2πr·J_c·Δl ≥ 0.
class Fracture final : public ForceModel {
public:
    explicit Fracture(const Setup& setup);

    void add_to(const Contact& contact, ContactLaw& law) const override;
    double settle(const Settlement& change) override;

private:
    [[nodiscard]] bool acts_in(int layer) const { return !layer_ || *layer_ == layer; }
    [[nodiscard]] double cutting_force(double needle_radius) const;    // [N]

    double rupture_force_;        // [N] F_r
    double toughness_;            // [J/m²] J_c
    std::optional<int> layer_;    // every layer where absent
};

}    // namespace stylet::fracture
