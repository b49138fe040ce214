// A joint: where two edges of the chain meet, and how they bend and twist against each other.
#pragma once

#include <stylet/types.h>

namespace stylet::rod {

/// An edge as a joint sees it.
struct Edge {
    Vector3 tangent;          // unit
    double length;            // [m] as it is now
    Vector3 first, second;    // unit, the material's directors across it; first × second = tangent
};

/// Derivatives by the two edges' vectors and by the angles of their material about them: [e (3), θe, f (3), θf].
using JointVector = Eigen::Matrix<double, 8, 1>;
using JointMatrix = Eigen::Matrix<double, 8, 8>;

/// What a joint is strained by: the discrete curvature κ1, κ2 in the material's directors and the twist m,
///
///     b = 2 te × tf/(1 + te·tf)      κ1 = b·(d2e + d2f)/2      κ2 = −b·(d1e + d1f)/2      m = θf − θe + m_ref
///
/// dimensionless: κ and m over the joint's own length are curvature [1/m] and twist rate [rad/m]. κ1 > 0 turns toward d1, κ2 > 0
/// toward d2. Source: Bergou, Wardetzky, Robinson, Audoly, Grinspun 2008; Bergou et al. 2010 for the derivatives, which hold
/// where a change of an edge transports its directors in parallel.
using Strain = Vector3;

class Joint {
public:
    /// `twist` [rad] is m: the directors alone don't tell how many turns they have made. Edges may not be opposite to each other.
    Joint(const Edge& e, const Edge& f, double twist);

    [[nodiscard]] const Strain& strain() const { return strain_; }

    /// ∇κ1, ∇κ2 and ∇m [1/m, 1].
    struct Gradients {
        JointVector first, second, twist;

        [[nodiscard]] JointVector weighed(const Vector3& moments) const {
            return moments[0] * first + moments[1] * second + moments[2] * twist;
        }
    };
    [[nodiscard]] Gradients gradients() const;

    /// moments1 ∇²κ1 + moments2 ∇²κ2 + moments3 ∇²m; the moments [N·m] are the joint's own.
    [[nodiscard]] JointMatrix hessian(const Vector3& moments) const;

private:
    void add_bending(const Vector3& moments, JointMatrix& h) const;
    void add_twisting(double torque, JointMatrix& h) const;

    Edge e_, f_;
    double chi_;          // 1 + te·tf
    Vector3 binormal_;    // b
    Vector3 mean_;        // (te + tf)/χ
    Strain strain_;
};

}    // namespace stylet::rod
