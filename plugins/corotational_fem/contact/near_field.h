// What a needle feels of a tissue between its own radius and a mesh's tetrahedra.
#pragma once

#include "contact/gaussian_load.h"
#include "contact/regions_felt.h"
#include "contact/spread.h"

#include <stylet/footprint.h>
#include <stylet/layered_elasticity.h>
#include <stylet/mindlin_kernel.h>
#include <stylet/setup.h>

#include <vector>

namespace stylet::corotational_fem {

/// The compliance between contacts that their mesh can't resolve:
///
///     C_ij = [mean over both pieces of track of K(x, y) − mean over both rows of balls of G(x, y)]/√(E_i E_j)
///
/// K is MindlinKernel at the needle's radius, at the tip at least that of a punch on the surface, as in half_space; G the same
/// half-space under the load that the mesh does resolve, spread over Spread's balls (GaussianLoad, σ = ρ/3). Added to the mesh's
/// own compliance of these balls, that is a needle in a body of the mesh's shape. C is short-ranged but for K's own blur, and
/// positive by itself.
///
/// Measured on 100 × 100 × 50 mm held at the bottom, cells of 17, 9 and 7 mm, needle of 0.3 mm, up to 30 mm deep, ν 0.45 and
/// 0.49: with pressure by patch a tip is equally soft within 0.3 %, a needle that its contacts stick to within 1 % downwards and
/// 2 % sideways; far from all sides it is half_space's within 0.5 %. With pressure by tetrahedron at ν 0.49 the mesh locks: the
/// three are up to 5 % apart, and up to 10 % too stiff.
///
/// Source: ours; K's is half_space's. Deviation: within ρ of a contact the answer is a half-space's, at rest, of a layer's
/// modulus blended as half_space does: sides, bottom, the other layers and inertia are felt no finer than that. Validity: small
/// strain.
class NearField {
public:
    /// All must outlive it. `regions` say what is where in a mesh from a file; none: the tissue's layers are stacked.
    NearField(const TissueSetup& tissue, const Spread& spread, const RegionsFelt* regions = nullptr);

    /// Contact i is there from now on. One that was there already costs nothing.
    void place(int contact, const ContactPoint& point);

    /// C of the first n contacts [m/N], 3n × 3n, symmetric; holds until the next call. Every one has been placed; works out what
    /// has changed since the last call only.
    [[nodiscard]] Eigen::Map<const MatrixX, Eigen::Unaligned, Eigen::OuterStride<>> compliance(int contacts);

    /// What to add to the mesh's displacement at a material point [m] under these forces (3n, [N]) on the first n contacts, as
    /// they were placed last: what a picture shows. Finite at contacts too.
    [[nodiscard]] Vector3 displacement(const Vector3& material, Forces forces) const;

private:
    struct Placed {
        Footprint footprint;
        Balls balls;
        std::array<GaussianLoad, Balls::most> loads;    // one for each ball
        double length = 0.0;                            // [m]
        double poisson_ratio = 0.0;
        double weight = 0.0;     // [1/√Pa] 1/√E
        bool changed = false;    // its rows have not been worked out yet

        [[nodiscard]] auto centres() const { return std::span(balls.centres).first(balls.count); }
        [[nodiscard]] auto shares() const { return std::span(loads).first(balls.count); }
    };

    [[nodiscard]] Placed placed(const ContactPoint& point) const;
    [[nodiscard]] Felt felt_at(const Vector3& point) const;
    [[nodiscard]] static Matrix3 meshed(const Placed& i, const Placed& j);
    [[nodiscard]] Matrix3 block(const Placed& i, const Placed& j) const;
    [[nodiscard]] Matrix3 own_block(const Placed& i) const;
    void fill(int row, int count);

    LayeredElasticity elasticity_;
    const RegionsFelt* regions_;
    const Spread& spread_;
    std::vector<Placed> placed_;
    int known_ = 0;    // how many contacts, from the first, C is filled for
    MatrixX compliance_;
};

}    // namespace stylet::corotational_fem
