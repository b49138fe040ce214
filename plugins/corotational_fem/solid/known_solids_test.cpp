// Solids whose answer is known exactly: affine strain, traction, and the order at which linear tetrahedra come near to the rest.
#include "solid/half_space_answers.h"
#include "solid/test_solids.h"

#include <gtest/gtest.h>

#include <cstdio>

namespace stylet::corotational_fem {
namespace {

using namespace testing;

constexpr double youngs_modulus = 25e3;    // [Pa]
constexpr double cell = 0.01;              // [m]
constexpr double still = 1e-13;            // [N] largest imbalance: some units in the last place of E h² = 2.5 N, times a strain

class KnownSolid : public ::testing::TestWithParam<bool> {};

// The patch test, validation.md: exact to 1e-10 of the body's size.
TEST_P(KnownSolid, AnAffineStrainAtTheBoundaryIsAffineWithin) {
    constexpr double exact = 1e-10;
    const double length = 4.0 * cell;
    for (const double degrees : {0.0, 30.0, 90.0, 175.0}) {
        Matrix3 stretched;
        stretched << 1.15, 0.04, -0.02, 0.04, 0.95, 0.06, -0.02, 0.06, 1.05;
        const Matrix3 deformation = turn(degrees, {2.0, -1.0, 3.0}) * stretched;
        for (const double irregular : {0.0, 0.2}) {
            const Mesh mesh = jiggled(block(Vector3::Constant(length), {4, 4, 4}), irregular * cell, 7);
            Supported body(mesh, elastic(youngs_modulus, 0.45), GetParam());
            const VectorX affine =
                field(mesh, [&](const Vector3& x) { return Vector3(deformation * x - x + Vector3(0.02, -0.01, 0.03)); });
            const std::vector<bool> outer = on_boundary(mesh);
            for (int i = 0; i < mesh.node_count(); ++i) {
                if (outer[i]) body.hold(i, affine.segment<3>(3 * i));
            }
            const VectorX elsewhere = affine + noise(affine.size(), 0.2 * cell, 3);
            const VectorX u = body.settle(elsewhere, VectorX::Zero(affine.size()), still);
            const double off = (u - affine).lpNorm<Eigen::Infinity>() / length;
            std::printf("%s, turned by %.0f degrees, nodes moved by %.1f h: off by %.1e of the length after %d steps\n",
                        pressure(GetParam()), degrees, irregular, off, body.steps());
            EXPECT_LE(off, exact);
        }
    }
}

// Forces [N] of a stress [Pa] upward on the top of a mesh, z = 0.
VectorX pull_on_top(const Mesh& mesh, double stress) {
    VectorX forces = VectorX::Zero(3 * mesh.node_count());
    for (const Tetrahedron& t : mesh.tetrahedra) {
        for (int apex = 0; apex < 4; ++apex) {
            const int face[] = {t[(apex + 1) % 4], t[(apex + 2) % 4], t[(apex + 3) % 4]};
            const Vector3 &a = mesh.nodes[face[0]], &b = mesh.nodes[face[1]], &c = mesh.nodes[face[2]];
            if (std::min({a.z(), b.z(), c.z()}) < -1e-9) continue;
            for (const int node : face) forces[3 * node + 2] += stress * 0.5 * (b - a).cross(c - a).norm() / 3.0;
        }
    }
    return forces;
}

// The bottom on rollers, its middle held and one more node kept from turning about it.
void stand(Supported& bar, double height) {
    for (int i = 0; i < bar.mesh().node_count(); ++i) {
        const Vector3& x = bar.mesh().nodes[i];
        if (x.z() > 1e-9 - height) continue;
        bar.hold(3 * i + 2, 0.0);
        if (std::abs(x.y()) > 1e-9) continue;
        bar.hold(3 * i + 1, 0.0);
        if (std::abs(x.x()) < 1e-9) bar.hold(3 * i, 0.0);
    }
}

// A bar pulled at its top. 2μ(s − 1) + λθ makes the nominal stress linear in the stretch: exact for any p.
TEST_P(KnownSolid, TractionStrainsABarByItsQuotientWithYoungsModulus) {
    constexpr double exact = 1e-9, height = 4.0 * cell;
    for (const double poisson_ratio : {0.0, 0.3, 0.49}) {
        for (const double strain : {1e-6, 1e-3, 0.1, -0.1}) {
            const Mesh mesh = jiggled(block(cell * Vector3(2.0, 2.0, 4.0), {2, 2, 4}), 0.2 * cell, 7);
            Supported bar(mesh, elastic(youngs_modulus, poisson_ratio), GetParam());
            stand(bar, height);
            const VectorX forces = pull_on_top(mesh, youngs_modulus * strain);
            const VectorX u = bar.settle(VectorX::Zero(forces.size()), forces, still);
            const VectorX expected = field(mesh, [&](const Vector3& x) {
                return Vector3(strain * Vector3(-poisson_ratio * x.x(), -poisson_ratio * x.y(), x.z() + height));
            });
            const double off = (u - expected).lpNorm<Eigen::Infinity>() / (std::abs(strain) * height);
            std::printf("%s, nu %.2f, p/E = %g: displacement off by %.1e of the extension\n", pressure(GetParam()), poisson_ratio,
                        strain, off);
            EXPECT_LE(off, exact);
        }
    }
}

struct Errors {
    double displacement, energy;    // of the exact solution's norms
};

// ∫ over the tetrahedra by the rule of four points, exact for quadratics.
template <typename Integrand>
double integral(const Mesh& mesh, const Integrand& integrand) {
    constexpr double near = 0.5854101966249685, far = 0.1381966011250105;
    double sum = 0.0;
    for (int e = 0; e < mesh.size(); ++e) {
        for (int point = 0; point < 4; ++point) {
            Eigen::Vector4d at = Eigen::Vector4d::Constant(far);
            at[point] = near;
            sum += 0.25 * volume_of(mesh, mesh.tetrahedra[e]) * integrand(mesh.tetrahedra[e], at);
        }
    }
    return sum;
}

double energy_density(const Matrix3& gradient, const Material& material) {
    const Matrix3 strain = 0.5 * (gradient + gradient.transpose());
    return material.shear_modulus * strain.squaredNorm() + 0.5 * material.lame * strain.trace() * strain.trace();
}

// A cube somewhere under a point load on a half-space, its boundary moved as Boussinesq says.
Errors errors_under_a_point_load(int cells, bool share_pressure, double irregular) {
    constexpr double size = 0.03, poisson_ratio = 0.3;    // [m], 1
    const double h = size / cells;
    Mesh mesh = jiggled(block(Vector3::Constant(size), {cells, cells, cells}), irregular * h, 11);
    for (Vector3& x : mesh.nodes) x += Vector3(0.03, 0.01, -0.02);
    const Material material = elastic(youngs_modulus, poisson_ratio);
    const auto exact = [&](const Vector3& x) { return boussinesq(x, 1.0, youngs_modulus, poisson_ratio); };

    Supported cube(mesh, material, share_pressure);
    const std::vector<bool> outer = on_boundary(mesh);
    for (int i = 0; i < mesh.node_count(); ++i) {
        if (outer[i]) cube.hold(i, exact(mesh.nodes[i]));
    }
    const VectorX u = cube.linear(VectorX::Zero(3 * mesh.node_count()));

    const auto place = [&](const Tetrahedron& t, const Eigen::Vector4d& at, auto&& value) {
        Vector3 sum = Vector3::Zero();
        for (int a = 0; a < 4; ++a) sum += at[a] * value(t[a]);
        return sum;
    };
    const auto node = [&](int i) { return mesh.nodes[i]; };
    const auto moved = [&](int i) { return Vector3(u.segment<3>(3 * i)); };
    const auto gradient = [&](const Vector3& x) {
        constexpr double step = 1e-7;    // [m]
        Matrix3 sum;
        for (int i = 0; i < 3; ++i)
            sum.col(i) = (exact(x + step * Vector3::Unit(i)) - exact(x - step * Vector3::Unit(i))) / (2.0 * step);
        return sum;
    };
    const auto gradient_within = [&](const Tetrahedron& t) {
        Matrix3 edges, ends;
        for (int i = 0; i < 3; ++i) {
            edges.col(i) = node(t[i + 1]) - node(t[0]);
            ends.col(i) = moved(t[i + 1]) - moved(t[0]);
        }
        return Matrix3(ends * edges.inverse());
    };
    const auto norm = [&](auto&& integrand) { return std::sqrt(integral(mesh, integrand)); };
    return {norm([&](const Tetrahedron& t, const Eigen::Vector4d& at) {
                return (place(t, at, moved) - exact(place(t, at, node))).squaredNorm();
            }) / norm([&](const Tetrahedron& t, const Eigen::Vector4d& at) { return exact(place(t, at, node)).squaredNorm(); }),
            norm([&](const Tetrahedron& t, const Eigen::Vector4d& at) {
                return energy_density(gradient_within(t) - gradient(place(t, at, node)), material);
            }) / norm([&](const Tetrahedron& t, const Eigen::Vector4d& at) {
                return energy_density(gradient(place(t, at, node)), material);
            })};
}

// validation.md: displacement O(h²), energy norm O(h).
TEST_P(KnownSolid, LinearTetrahedraConvergeAtTheirOrder) {
    constexpr double displacement_order = 2.0, energy_order = 1.0;
    constexpr double fitted = 0.15;    // meshes as coarse as these are not quite where the order is the asymptotic one
    for (const double irregular : {0.0, 0.15}) {
        std::vector<double> sizes, displacements, energies;
        for (const int cells : {3, 6, 12}) {
            const Errors errors = errors_under_a_point_load(cells, GetParam(), irregular);
            std::printf("%s, %2d cells, nodes moved by %.2f h: displacement off by %.3f %%, strain energy's root by %.2f %%\n",
                        pressure(GetParam()), cells, irregular, 1e2 * errors.displacement, 1e2 * errors.energy);
            sizes.push_back(1.0 / cells);
            displacements.push_back(errors.displacement);
            energies.push_back(errors.energy);
        }
        std::printf("%s: fitted orders %.2f and %.2f\n", pressure(GetParam()), order_of(sizes, displacements),
                    order_of(sizes, energies));
        EXPECT_NEAR(order_of(sizes, displacements), displacement_order, fitted);
        EXPECT_NEAR(order_of(sizes, energies), energy_order, fitted);
    }
}

INSTANTIATE_TEST_SUITE_P(Pressure, KnownSolid, ::testing::Bool(),
                         [](const auto& with) { return with.param ? "PerPatch" : "PerTetrahedron"; });

}    // namespace
}    // namespace stylet::corotational_fem
