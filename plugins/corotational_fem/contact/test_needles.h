// Needles in blocks of tissue, for tests: what the mesh, the near field and both together answer at rest.
#pragma once

#include "contact/near_field.h"
#include "mesh/block_mesh.h"
#include "solid/newton.h"

#include <limits>
#include <vector>

namespace stylet::corotational_fem::testing {

using Points = std::vector<ContactPoint>;

inline TissueSetup block_of(const Vector3& extent, double youngs_modulus, double poisson_ratio) {
    const Layer gel{.name = "gel",
                    .youngs_modulus = youngs_modulus,
                    .poisson_ratio = poisson_ratio,
                    .density = std::numeric_limits<double>::quiet_NaN(),
                    .thickness = extent.z()};
    return {.extent = extent, .fixed = "bottom", .layers = {gel}};
}

inline ContactPoint tip_at(const Vector3& material) {
    return {.material = material, .span = Vector3::Zero(), .arclength = 0.0, .tip = true};
}

inline ContactPoint shaft(const Vector3& from, const Vector3& to) {
    return {.material = from, .span = to - from, .arclength = 0.0, .tip = false};
}

/// A tip and, behind it, its track from the surface in pieces.
inline Points needle(const Vector3& entry, const Vector3& direction, double length, double piece) {
    const Vector3 way = direction.normalized();
    Points points{tip_at(entry + length * way)};
    for (double s = 0.0; s < length - 1e-9; s += piece)
        points.push_back(shaft(entry + s * way, entry + std::min(s + piece, length) * way));
    return points;
}

/// A needle of this radius in a meshed tissue at rest.
class Needled {
public:
    Needled(const TissueSetup& tissue, Mesh mesh, double radius, bool share_pressure)
        : tissue_(tissue),
          mesh_(std::move(mesh)),
          materials_(materials_of(tissue)),
          spread_(mesh_, radius),
          near_field_(tissue_, spread_),
          newton_(mesh_, materials_, {.share_pressure = share_pressure}) {}

    Spread& spread() { return spread_; }
    NearField& near_field() { return near_field_; }
    [[nodiscard]] const Mesh& mesh() const { return mesh_; }
    Newton& newton() { return newton_; }

    /// [m/N], the mesh's share.
    MatrixX meshed(const Points& points) {
        const auto count = static_cast<Eigen::Index>(points.size());
        for (int i = 0; i < count; ++i) newton_.place(i, spread_.of(points[i]));
        VectorX free(3 * count);
        MatrixX compliance(3 * count, 3 * count);
        newton_.linearise(static_cast<int>(count), free, compliance);
        return compliance;
    }

    /// [m/N], the near field's share.
    MatrixX near(const Points& points) {
        for (std::size_t i = 0; i < points.size(); ++i) near_field_.place(static_cast<int>(i), points[i]);
        return near_field_.compliance(static_cast<int>(points.size()));
    }

    MatrixX compliance(const Points& points) { return meshed(points) + near(points); }    // [m/N]

private:
    static std::vector<Material> materials_of(const TissueSetup& tissue) {
        std::vector<Material> materials;
        for (const auto& [name, modulus, nu, density, thickness] : tissue.layers)
            materials.push_back({.shear_modulus = modulus / (2.0 * (1.0 + nu)),
                                 .lame = modulus * nu / ((1.0 + nu) * (1.0 - 2.0 * nu)),
                                 .density = density});
        return materials;
    }

    TissueSetup tissue_;
    Mesh mesh_;
    std::vector<Material> materials_;
    Spread spread_;
    NearField near_field_;
    Newton newton_;
};

/// [m/N] how far a needle that its contacts stick to moves as a whole along an axis.
inline double rigid_compliance(const MatrixX& compliance, int axis) {
    VectorX one = VectorX::Zero(compliance.rows());
    for (Eigen::Index i = axis; i < one.size(); i += 3) one[i] = 1.0;
    return 1.0 / one.dot(compliance.ldlt().solve(one));
}

/// [m/N] of the same contacts in half_space.
inline MatrixX half_space(const Points& points, double youngs_modulus, double poisson_ratio, double radius) {
    const MindlinKernel kernel(poisson_ratio, radius);
    const auto count = static_cast<Eigen::Index>(points.size());
    MatrixX all(3 * count, 3 * count);
    for (Eigen::Index i = 0; i < count; ++i) {
        for (Eigen::Index j = 0; j < count; ++j) {
            const Footprint a(points[i]), b(points[j]);
            Matrix3 sum = Matrix3::Zero();
            for (const Vector3& x : a.samples())
                for (const Vector3& y : b.samples()) sum += kernel(x, y);
            sum /= static_cast<double>(a.samples().size() * b.samples().size());
            if (i == j && points[i].tip)
                sum.diagonal() = sum.diagonal().cwiseMax(kernel(Vector3::Zero(), Vector3::Zero()).diagonal());
            all.block<3, 3>(3 * i, 3 * j) = sum / youngs_modulus;
        }
    }
    return all;
}

}    // namespace stylet::corotational_fem::testing
