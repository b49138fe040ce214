// The co-rotational solid in double precision: energy, forces and tangent, each as its formula says.
#pragma once

#include "mesh/mesh.h"
#include "solid/polar.h"
#include "solid/tangent.h"

#include <cstdint>
#include <span>
#include <vector>

namespace stylet::corotational_fem {

/// What a tangent makes of a twist whose stiffness 2μ + (λθ − 2μ) 2/(s_i + s_j) is negative, as under strong compression: leaves
/// it so, or takes it for free, which keeps each tetrahedron's tangent positive semidefinite.
enum class Twists : std::uint8_t { exact, definite };

/// Linear tetrahedra whose strain is measured in a frame that turns with each of them:
///
///     Ψ = μ ‖F − R‖² + λ/2 θ²,   θ = tr(RᵀF) − 3,   P = ∂Ψ/∂F = 2μ (F − R) + λ θ R
///
/// with F = I + Σ u_a ⊗ ∇N_a and R the rotation of F (Polar). As R minimises ‖F − R‖, P is exactly the energy's derivative: what
/// is inexact in the warped stiffness R K Rᵀ of Müller and Gross 2004 is its tangent alone. With `share_pressure`, θ is averaged
/// over each of Mesh::patches (an F-bar patch, de Souza Neto, Andrade Pires and Owen 2005, in this strain), which unlocks nearly
/// incompressible tissue; deviation: their patch is of J, ours of θ, which is what this energy is made of.
///
/// Validity: large rotations; stretches of some tens of percent, for the stress is linear in the stretch. An inverted tetrahedron
/// is pushed back.
///
/// Vectors are 3n, xyz of each node of the mesh, held ones included.
class Solid {
public:
    /// `mesh` must outlive it.
    Solid(const Mesh& mesh, std::span<const Material> materials, bool share_pressure);

    /// Energy [J] at displacements u [m]; adds its derivative, the internal forces [N], to `forces`.
    double strain(const VectorX& u, VectorX& forces);

    /// Adds the forces of a Kelvin–Voigt damper, τ/dt C:sym(Rᵀ(F − F_from)) for `rate` = τ/dt, in the frame R that each
    /// tetrahedron had at `from`: so they are linear in u and half of what they dissipate is their potential, without which a
    /// step has no function that its iterations bring down. Volume changes are averaged as those of the strain are. Returns what
    /// they dissipate on the way from `from` [J]; never negative.
    double damp(const VectorX& u, const VectorX& from, double rate, VectorX& forces);

    /// Adds the tangent ∂²Ψ/∂u² at u.
    void stiffen(const VectorX& u, Twists twists, Tangent& tangent);

    /// Adds the derivative of damp's forces, the same at any u.
    void stiffen_damper(const VectorX& from, double rate, Tangent& tangent);

    /// Whether a tetrahedron was turned inside out where `strain` was asked last.
    [[nodiscard]] bool inverted() const { return inverted_; }

    /// What rounding leaves uncertain of the force on a node [N], for a strain is known to a few units in the last place of one.
    [[nodiscard]] double rounding() const;

private:
    void measure(const VectorX& u);

    struct Shape {
        Eigen::Matrix<double, 3, 4> gradients;    // [1/m] ∇N of each node
        double volume;                            // [m³]
        double shear_modulus, lame;               // [Pa]
    };
    struct Patch {
        double volume = 0.0;    // [m³]
        std::vector<int> tetrahedra;
        std::vector<int> nodes;
    };

    [[nodiscard]] Matrix3 gradient_of(const VectorX& u, int tetrahedron) const;
    void average_dilatations();
    void push(int tetrahedron, const Matrix3& stress, VectorX& forces) const;
    void stiffen_own(int tetrahedron, double factor, Twists twists, Tangent& tangent) const;
    void stiffen_shared(const Patch& patch, double factor, Tangent& tangent) const;

    const Mesh& mesh_;
    std::vector<Shape> shapes_;
    std::vector<Patch> patches_;    // none: each tetrahedron has its own pressure
    bool inverted_ = false;
    std::vector<Polar> polars_;          // of each tetrahedron, of the last displacements seen
    std::vector<Matrix3> strains_;       // F − R of each
    std::vector<double> dilatations_;    // θ of each, averaged over its patch
};

}    // namespace stylet::corotational_fem
