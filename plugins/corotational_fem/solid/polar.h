// The rotation in a deformation, whatever has become of the tetrahedron.
#pragma once

#include <stylet/types.h>

#include <cmath>

namespace stylet::corotational_fem {

/// F = U diag(s) Vᵀ with proper rotations U and V, so that an inverted F has its least stretch negative; R = U Vᵀ is the rotation
/// of the polar decomposition F = R S. Of a flat or collapsed F it is one of those that are as good, the same each time. Source:
/// Irving, Teran and Fedkiw 2004, section 5.
struct Polar {
    Matrix3 left;         // U
    Vector3 stretches;    // s, greatest first
    Matrix3 right;        // V

    explicit Polar(const Matrix3& deformation) {
        const Eigen::JacobiSVD<Matrix3> svd(deformation, Eigen::ComputeFullU | Eigen::ComputeFullV);
        left = svd.matrixU();
        right = svd.matrixV();
        stretches = svd.singularValues();
        if (left.determinant() < 0.0) turn_last(left);
        if (right.determinant() < 0.0) turn_last(right);
    }

    [[nodiscard]] Matrix3 rotation() const { return left * right.transpose(); }

    /// The unit direction, up to a factor, in which F turns about the k-th axis of U without stretching: U T_k Vᵀ/√2, with T_k
    /// the cross product with the k-th unit vector. dR = Σ_k 2/(s_i + s_j) (t_k : dF) t_k (Smith, de Goes and Kim 2019, eq. 24).
    [[nodiscard]] Matrix3 twist(int k) const {
        const int i = (k + 1) % 3, j = (k + 2) % 3;
        return std::sqrt(0.5) * (left.col(j) * right.col(i).transpose() - left.col(i) * right.col(j).transpose());
    }

    /// s_i + s_j of the two stretches across the k-th axis.
    [[nodiscard]] double across(int k) const { return stretches[(k + 1) % 3] + stretches[(k + 2) % 3]; }

private:
    void turn_last(Matrix3& rotation) {
        rotation.col(2) *= -1.0;
        stretches[2] *= -1.0;
    }
};

}    // namespace stylet::corotational_fem
