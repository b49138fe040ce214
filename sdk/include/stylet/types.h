// The plain values that cross the border between core and a plugin. SI units, world frame: z up, undeformed surface at z = 0.
#pragma once

#include <Eigen/Dense>

namespace stylet {

using Vector3 = Eigen::Vector3d;
using Matrix3 = Eigen::Matrix3d;
using VectorX = Eigen::VectorXd;
using MatrixX = Eigen::MatrixXd;

/// A quaternion whose alignment no compiler flag changes, so that it may cross a library border by value.
using Quaternion = Eigen::Quaternion<double, Eigen::DontAlign>;

/// Where the hand holds the needle's base. At rotation identity the needle points to −z and bows in +x.
struct Pose {
    Vector3 position = Vector3::Zero();              // [m]
    Quaternion rotation = Quaternion::Identity();    // unit, needle frame to world

    [[nodiscard]] Vector3 axis() const { return rotation * Vector3(0.0, 0.0, -1.0); }
    [[nodiscard]] Vector3 bow_direction() const { return rotation * Vector3(1.0, 0.0, 0.0); }
    [[nodiscard]] bool finite() const { return position.allFinite() && rotation.coeffs().allFinite(); }
};

/// A force and a moment about the base.
struct Wrench {
    Vector3 force = Vector3::Zero();     // [N]
    Vector3 moment = Vector3::Zero();    // [N·m]

    [[nodiscard]] bool finite() const { return force.allFinite() && moment.allFinite(); }
};

}    // namespace stylet
