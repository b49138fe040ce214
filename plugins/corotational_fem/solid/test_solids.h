// Solids for tests: blocks, and a Newton's method of the tests' own that holds single coordinates, which the plugin's can't.
#pragma once

#include "mesh/block_mesh.h"
#include "solid/solid.h"

#include <Eigen/SparseCholesky>

#include <iostream>    // that MetisSupport forgets

#include <Eigen/MetisSupport>

#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <random>

namespace stylet::corotational_fem::testing {

using Cells = std::array<int, 3>;

inline Material elastic(double youngs_modulus, double poisson_ratio, double density = std::numeric_limits<double>::quiet_NaN()) {
    return {.shear_modulus = youngs_modulus / (2.0 * (1.0 + poisson_ratio)),
            .lame = youngs_modulus * poisson_ratio / ((1.0 + poisson_ratio) * (1.0 - 2.0 * poisson_ratio)),
            .density = density};
}

/// A block of one layer, held at the bottom; x and y about zero, z from −extent to zero.
inline Mesh block(const Vector3& extent, const Cells& cells) {
    const Layer layer{.name = "all", .youngs_modulus = 1.0, .poisson_ratio = 0.0, .density = 1.0, .thickness = extent.z()};
    return block_mesh({.extent = extent, .fixed = "bottom", .layers = {layer}}, cells);
}

inline double volume_of(const Mesh& mesh, const Tetrahedron& t) {
    const Vector3 a = mesh.nodes[t[1]] - mesh.nodes[t[0]], b = mesh.nodes[t[2]] - mesh.nodes[t[0]];
    return a.cross(b).dot(mesh.nodes[t[3]] - mesh.nodes[t[0]]) / 6.0;    // [m³]
}

/// Whether a node lies on the box around the mesh.
inline std::vector<bool> on_boundary(const Mesh& mesh) {
    Vector3 least = mesh.nodes.front(), greatest = least;
    for (const Vector3& x : mesh.nodes) {
        least = least.cwiseMin(x);
        greatest = greatest.cwiseMax(x);
    }
    const double near = 1e-9 * (greatest - least).norm();
    std::vector<bool> at(mesh.nodes.size());
    for (std::size_t i = 0; i < at.size(); ++i) {
        at[i] = (mesh.nodes[i] - least).minCoeff() < near || (greatest - mesh.nodes[i]).minCoeff() < near;
    }
    return at;
}

/// Moves the inner nodes by up to `distance` [m] each way, so that no two tetrahedra are alike.
inline Mesh jiggled(Mesh mesh, double distance, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> by(-distance, distance);
    const std::vector<bool> outer = on_boundary(mesh);
    for (int i = 0; i < mesh.node_count(); ++i) {
        if (!outer[i]) mesh.nodes[i] += Vector3(by(random), by(random), by(random));
    }
    return mesh;
}

/// Displacements [m] that a function of the undeformed place gives.
template <typename Displacement>
VectorX field(const Mesh& mesh, const Displacement& displacement) {
    VectorX u(3 * mesh.node_count());
    for (int i = 0; i < mesh.node_count(); ++i) u.segment<3>(3 * i) = displacement(mesh.nodes[i]);
    return u;
}

/// Numbers between −scale and scale.
inline VectorX noise(Eigen::Index count, double scale, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> some(-scale, scale);
    return VectorX::NullaryExpr(count, [&] { return some(random); });
}

inline Matrix3 turn(double degrees, const Vector3& axis) {
    return Eigen::AngleAxisd(degrees * std::numbers::pi / 180.0, axis.normalized()).toRotationMatrix();
}

/// The least-squares slope of log y over log x.
inline double order_of(const std::vector<double>& x, const std::vector<double>& y) {
    double n = 0.0, sx = 0.0, sy = 0.0, sxx = 0.0, sxy = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const double a = std::log(x[i]), b = std::log(y[i]);
        n += 1.0, sx += a, sy += b, sxx += a * a, sxy += a * b;
    }
    return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

/// A solid with any of its coordinates held, brought to rest.
class Supported {
public:
    Supported(Mesh mesh, const Material& material, bool share_pressure)
        : mesh_(loose(std::move(mesh))),
          materials_{material},
          solid_(mesh_, materials_, share_pressure),
          tangent_(mesh_, share_pressure) {}

    [[nodiscard]] const Mesh& mesh() const { return mesh_; }
    Solid& solid() { return solid_; }

    /// Coordinate 3·node + axis is moved by this much [m].
    void hold(int coordinate, double displacement) { held_[coordinate] = displacement; }

    void hold(int node, const Vector3& displacement) {
        for (int i = 0; i < 3; ++i) hold(3 * node + i, displacement[i]);
    }

    void let_go() { held_.clear(); }

    /// As in linear elasticity: one step of the tangent at rest.
    VectorX linear(const VectorX& forces) {
        VectorX u = VectorX::Zero(forces.size());
        tangent_.clear();
        solid_.stiffen(u, Twists::exact, tangent_);
        for (const auto& [coordinate, displacement] : held_) u[coordinate] = displacement;
        const VectorX inner = tangent_.matrix().selfadjointView<Eigen::Lower>() * u;
        (void)factorise();
        u += ahead(forces - inner);
        return u;
    }

    /// Newton's method from u, halving steps until the potential falls, to an imbalance of `tolerance` [N]. NaN where it doesn't
    /// get there.
    VectorX settle(VectorX u, const VectorX& forces, double tolerance) {
        for (const auto& [coordinate, displacement] : held_) u[coordinate] = displacement;
        for (steps_ = 0; steps_ < most_steps; ++steps_) {
            VectorX inner = VectorX::Zero(u.size());
            const double before = solid_.strain(u, inner) - forces.dot(u);
            VectorX residual = forces - inner;
            for (const auto& [coordinate, displacement] : held_) residual[coordinate] = 0.0;
            if (residual.lpNorm<Eigen::Infinity>() <= tolerance) return u;
            for (const Twists twists : {Twists::exact, Twists::definite}) {
                tangent_.clear();
                solid_.stiffen(u, twists, tangent_);
                if (factorise()) break;
            }
            const VectorX step = ahead(residual);
            double length = 1.0;
            const double slope = residual.dot(step), blur = 1e-13 * std::abs(before);
            while (length > 1e-6 && potential(u + length * step, forces) > before - 1e-4 * length * slope + blur) length *= 0.5;
            u += length * step;
        }
        return VectorX::Constant(u.size(), std::numeric_limits<double>::quiet_NaN());
    }

    [[nodiscard]] int steps() const { return steps_; }    // of the last settle

private:
    static constexpr int most_steps = 400;
    using Sparse = Eigen::SparseMatrix<double>;

    static Mesh loose(Mesh mesh) {
        std::fill(mesh.fixed.begin(), mesh.fixed.end(), char{0});
        return mesh;
    }

    double potential(const VectorX& u, const VectorX& forces) {
        VectorX inner = VectorX::Zero(u.size());
        return solid_.strain(u, inner) - forces.dot(u);    // [J]
    }

    // The tangent without its held rows and columns. Returns whether it is positive definite.
    bool factorise() {
        place_.assign(tangent_.matrix().rows(), -1);
        int free = 0;
        for (int i = 0; i < static_cast<int>(place_.size()); ++i) {
            if (!held_.contains(i)) place_[i] = free++;
        }
        std::vector<Eigen::Triplet<double>> entries;
        for (int column = 0; column < tangent_.matrix().outerSize(); ++column) {
            for (Sparse::InnerIterator at(tangent_.matrix(), column); at; ++at) {
                const int i = place_[at.row()], j = place_[column];
                if (i >= 0 && j >= 0) entries.emplace_back(i, j, at.value());
            }
        }
        Sparse matrix(free, free);
        matrix.setFromTriplets(entries.begin(), entries.end());
        factor_.compute(matrix);
        return factor_.info() == Eigen::Success && factor_.vectorD().minCoeff() > 0.0;
    }

    VectorX ahead(const VectorX& residual) {
        VectorX right(factor_.rows());
        for (std::size_t i = 0; i < place_.size(); ++i) {
            if (place_[i] >= 0) right[place_[i]] = residual[i];
        }
        right = factor_.solve(right).eval();
        VectorX step = VectorX::Zero(residual.size());
        for (std::size_t i = 0; i < place_.size(); ++i) {
            if (place_[i] >= 0) step[i] = right[place_[i]];
        }
        return step;
    }

    Mesh mesh_;
    std::vector<Material> materials_;
    Solid solid_;
    Tangent tangent_;
    std::map<int, double> held_;
    std::vector<int> place_;
    Eigen::SimplicialLDLT<Sparse, Eigen::Lower, Eigen::MetisOrdering<int>> factor_;
    int steps_ = 0;
};

/// The name of a pressure treatment, for printing.
inline const char* pressure(bool shared) {
    return shared ? "pressure per patch" : "pressure per tetrahedron";
}

}    // namespace stylet::corotational_fem::testing
