#pragma once

#include "rectangle.h"

#include <stylet/body.h>
#include <stylet/patch.h>
#include <stylet/setup.h>

#include <span>
#include <vector>

namespace stylet::half_space {

/// The patches of the surface that effects load: how far they move themselves, each other and what else there is.
///
/// A patch is a rectangle of uniform traction, of the modulus of the top layer. What belongs to the needle is felt with half its
/// blur (MindlinKernel): that is the square root of the spread which two of its contacts share, so that contacts and patches
/// together keep one symmetric, positive definite compliance.
class LoadedPatches {
public:
    /// `tissue` must outlive it. `half_blur` [m], zero where there is no needle.
    LoadedPatches(const TissueSetup& tissue, double half_blur);

    /// Forgets the former patches. Throws Error at `centre` or `size` for one that is no rectangle on the block's top, at
    /// `effects` for too many.
    void place(std::span<const Patch> patches);

    [[nodiscard]] bool none() const { return rectangles_.empty(); }
    [[nodiscard]] int count() const { return static_cast<int>(rectangles_.size()); }

    /// Of the m patches' means under their own forces [m/N], 3m × 3m.
    [[nodiscard]] const MatrixX& own() const { return own_; }

    /// Fills the rows of a contact whose force is shared evenly by n `samples` [m]; `weight` is 1/(n √E) [1/√Pa].
    void meet(int contact, std::span<const Vector3> samples, double weight);

    /// Of the first n contacts under the patches' forces [m/N], 3n × 3m. Its transpose is that of the patches under the
    /// contacts'.
    [[nodiscard]] auto of_contacts(Eigen::Index contacts) const { return of_contacts_.topRows(3 * contacts); }

    /// Displacement at a point under these forces (3m) [N], times √E there [m √Pa].
    [[nodiscard]] Vector3 displacement(const Vector3& x, const VectorX& forces) const;

private:
    [[nodiscard]] Rectangle rectangle_of(const Patch& patch) const;

    const TissueSetup& tissue_;
    double poisson_ratio_;
    double half_blur_;    // [m]
    double weight_;       // [1/√Pa] 1/√E of the top layer
    std::vector<Rectangle> rectangles_;
    MatrixX own_, of_contacts_;
};

}    // namespace stylet::half_space
