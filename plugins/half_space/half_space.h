// The cheapest honest tissue: an elastic half-space, no mesh.
#pragma once

#include "loaded_patches.h"

#include <stylet/footprint.h>
#include <stylet/layered_elasticity.h>
#include <stylet/mindlin_kernel.h>
#include <stylet/tissue_model.h>

#include <vector>

namespace stylet::half_space {

/// A linear elastic half-space that answers with one symmetric positive definite compliance over tip and shaft:
///
///     u_i = Σ_j W_ij f_j,    W_ij = mean over both pieces of track of K(x, y) / √(E_i E_j)
///
/// K is Mindlin's point load blurred to the needle's radius (mindlin_kernel.h). A shaft contact is a row of points along its
/// piece of track. The tip keeps the compliance of a punch on the surface at every depth: the track behind it is open, so it
/// doesn't feel the full space that an embedded disc would.
///
/// Patches of the surface that effects load are rectangles of uniform traction, solved in closed form (rectangle.h). They join
/// the same W: a load moves the contacts, the contacts' forces move its patch, and the energy is ½ fᵀWf over all of them.
///
/// Source: Mindlin 1936; Selvadurai 1976 for the disc; Love 1929 for the rectangle. Validity: small strain, quasi-static, one
/// Poisson ratio. Layers act by their local modulus, blended over four radii at an interface, a named approximation: exact for
/// one layer, positive definite for any, blind to what lies between two points; a tip that crosses into a stiffer layer loses
/// part of its dent and surges ahead. A patch has the modulus of the top layer, however far it reaches. The block's sides and
/// bottom are not felt: `extent` only says where the answer stops being vouched for.
class HalfSpace final : public TissueModel {
public:
    explicit HalfSpace(const Setup& setup);

    void predict(double) override;
    Linearisation linearise(ContactPoints points, double shift) override;
    StepReport try_step(ContactPoints points, Forces forces) override;
    void commit() override { state_ = trial_; }
    void rollback() override;
    EnergyReport energy() const override { return {.stored = trial_.energy}; }

    void bear(std::span<const Patch> patches) override;
    void load(std::span<const Vector3> forces) override;
    Vector3 patch_displacement(int i) const override { return trial_.patches_moved.segment<3>(3 * i); }

    /// As a contact of the needle's size would feel it there; finite at contacts and patches too. What lies above the surface or
    /// beside the block is given as if it were tissue.
    Vector3 displacement(const Vector3& material) const override;
    Location locate(const Vector3& material) const override;
    double entry(const Vector3& from, const Vector3& to) const override;
    const char* beyond_validity() const override;

    /// The compliance of the tip on the surface [m/N]: (1 − ν²)/(2aE) along z, (2 − ν)/(8Ga) across.
    Matrix3 punch(double youngs_modulus) const { return kernel_(Vector3::Zero(), Vector3::Zero()) / youngs_modulus; }

private:
    /// A contact as the compliance sees it.
    struct Placed {
        Footprint footprint;
        double weight = 0.0;    // 1/(n √E) of each of its n samples
    };
    /// A contact and what presses there.
    struct Pressed {
        ContactPoint point;
        Vector3 force;    // [N] on the tissue
    };
    struct State {
        double energy = 0.0;    // [J] ½ fᵀWf
        double spare = 0.0;     // [m] by how much a dent is less than the tissue of its modulus is thick; the least
        std::vector<Pressed> contacts;
        VectorX load;             // 3m, [N] on the patches
        VectorX patches_moved;    // 3m, [m] the means of their displacements
    };

    Placed place(const ContactPoint& point) const;
    Matrix3 block(const Placed& i, const Placed& j) const;
    void fill(int row, int count);
    void shift_contacts(ContactPoints points);
    void move_patches(const Forces& forces);
    int layer_at(double depth) const;
    double room_at(double depth) const;

    TissueSetup setup_;
    MindlinKernel kernel_;
    LayeredElasticity elasticity_;
    std::vector<double> bottoms_;    // [m] depth of each layer's bottom
    std::vector<Placed> placed_;
    LoadedPatches patches_;
    int known_ = 0;           // how many contacts, from the first, the compliance is filled for
    VectorX free_;            // 3n
    MatrixX compliance_;      // 3n × 3n
    VectorX displacement_;    // 3n, scratch of try_step
    VectorX shift_;           // 3n, [m] of the contacts, by the patches' loads
    VectorX next_load_;       // 3m, [N] from the next predict on
    State trial_, state_;
};

}    // namespace stylet::half_space
