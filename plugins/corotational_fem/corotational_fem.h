// Soft tissue as tetrahedra that turn with it: the paper's own, true to large rotations, any shape and any layers.
#pragma once

#include "contact/near_field.h"
#include "contact/spread.h"
#include "load/loaded_nodes.h"
#include "mesh/locator.h"
#include "solver.h"

#include <stylet/footprint.h>
#include <stylet/tissue_model.h>

#include <memory>
#include <optional>
#include <vector>

namespace stylet::corotational_fem {

/// A co-rotational finite-element solid (Solid says of what energy) under a needle that is far thinner than its tetrahedra.
///
///     u_i = J_i u + Σ_j C_ij f_j,    r(u) = w + f + Jᵀλ − ∂Ψ/∂u − M a = 0
///
/// J_i is the mean over the nodes about contact i (Spread), C what the mesh can't resolve of so small a thing (NearField), so
/// that force against depth doesn't depend on the mesh. Two solvers find r = 0: Newton, which is the reference, and QuasiNewton,
/// which is fast.
///
/// Source: He, Chen and Tang, Table 4; Müller and Gross 2004. Deviation: the exact derivative of the energy, not the warped
/// stiffness alone. Validity: Solid's and NearField's; the tissue doesn't touch itself, and is cut by the needle's track without
/// opening.
class CorotationalFem final : public TissueModel {
public:
    explicit CorotationalFem(const Setup& setup);

    void predict(double dt) override { solver_->predict(dt); }
    Linearisation linearise(ContactPoints points, double shift) override;
    StepReport try_step(ContactPoints points, Forces forces) override;
    void commit() override;
    void rollback() override;
    EnergyReport energy() const override;

    void bear(std::span<const Patch> patches) override;
    void load(std::span<const Vector3> forces) override { solver_->load(loaded_.share(forces)); }
    Vector3 patch_displacement(int i) const override;

    Vector3 displacement(const Vector3& material) const override;
    Location locate(const Vector3& material) const override;
    double entry(const Vector3& from, const Vector3& to) const override { return locator_.entry(from, to); }
    const char* beyond_validity() const override;

private:
    struct State {
        double near_energy = 0.0;    // [J] ½ fᵀCf
        double spare = 0.0;          // [m] by how much the tip's dent is less than the tissue below it is thick
        VectorX forces;              // 3 max_contacts, [N] on the tissue
        Eigen::Index count = 0;      // of contacts that they act on
    };

    void place(ContactPoints points);

    const TissueSetup& setup_;
    Mesh mesh_;
    std::vector<Material> materials_;
    Locator locator_;
    LoadedNodes loaded_;
    Spread spread_;
    std::optional<RegionsFelt> regions_;    // of a mesh from a file
    NearField near_field_;
    std::unique_ptr<Solver> solver_;
    std::vector<Footprint> placed_;    // as the solver and the near field know them
    VectorX free_;                     // 3n, [m]
    VectorX moved_;                    // 3n, [m], scratch
    MatrixX compliance_;               // 3n × 3n, [m/N] of the mesh and the near field
    State trial_, state_;
};

}    // namespace stylet::corotational_fem
