#include "contact/gaussian_load.h"

#include <stylet/mindlin_kernel.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <numbers>
#include <vector>

namespace stylet::corotational_fem {
namespace {

class GaussianLoadIn : public ::testing::TestWithParam<double> {};
INSTANTIATE_TEST_SUITE_P(PoissonRatios, GaussianLoadIn, ::testing::Values(0.3, 0.45, 0.49));

constexpr double spacing = 0.2;    // of the points that stand for a ball of radius 1; with 0.125 the means change by 0.5 %

/// A ball of radius 1 with density (1 − r²)², folded at the surface.
struct Ball {
    explicit Ball(const Vector3& centre) {
        const auto density = [](double rr) { return rr < 1.0 ? (1.0 - rr) * (1.0 - rr) : 0.0; };
        const Vector3 mirrored(centre.x(), centre.y(), -centre.z());
        double sum = 0.0;
        for (double x = -1.0; x < 1.05; x += spacing) {
            for (double y = -1.0; y < 1.05; y += spacing) {
                for (double z = -0.5 * spacing; z > centre.z() - 1.0; z -= spacing) {
                    const Vector3 point(centre.x() + x, centre.y() + y, z);
                    const double weight = density((point - centre).squaredNorm()) + density((point - mirrored).squaredNorm());
                    if (weight == 0.0) continue;
                    points.push_back(point);
                    weights.push_back(weight);
                    sum += weight;
                }
            }
        }
        for (double& weight : weights) weight /= sum;
    }
    std::vector<Vector3> points;
    std::vector<double> weights;
};

Matrix3 mean_of_mindlin(double nu, const Ball& a, const Ball& b) {
    // A cell under its own load: ⟨1/r⟩ over two points of a unit cube is 1.882; elsewhere the points are sharp.
    const MindlinKernel same(nu, 0.5 * std::numbers::pi * spacing / 1.882), other(nu, 1e-9);
    Matrix3 sum = Matrix3::Zero();
    for (std::size_t i = 0; i < a.points.size(); ++i) {
        for (std::size_t j = 0; j < b.points.size(); ++j) {
            const bool one = (a.points[i] - b.points[j]).norm() < 1e-6 * spacing;
            sum += a.weights[i] * b.weights[j] * (one ? same : other)(a.points[i], b.points[j]);
        }
    }
    return sum;
}

TEST_P(GaussianLoadIn, MovesAnotherLikeTheMeanOfMindlinsSolutionOverBalls) {
    constexpr double near = 0.1;          // within a ball's radius of the surface and of each other
    constexpr double far = 0.025;         // two radii from each other
    constexpr double of_itself = 0.05;    // a ball below the surface by more than its radius, under its own load
    const double nu = GetParam(), deviation = 1.0 / 3.0;
    for (const double dx : {0.0, 0.6, 1.2, 2.4}) {
        for (const double z : {0.0, 0.4, 1.6}) {
            for (const double c : {0.0, 0.4, 1.6, 3.2}) {
                if (c < z) continue;
                const Vector3 x(0.0, 0.0, -z), y(dx, 0.0, -c);
                const Matrix3 exact = mean_of_mindlin(nu, Ball(x), Ball(y));
                const Matrix3 ours = response(nu, {x, deviation}, {y, deviation});
                const double error = (ours - exact).norm() / exact.norm(), distance = (x - y).norm();
                std::printf(
                    "nu %.2f, depths %.1f and %.1f, %.1f apart: along z %.3f of %.4f, along x %.3f of %.4f, %.1f %% off\n", nu, z,
                    c, dx, ours(2, 2) / exact(2, 2), exact(2, 2), ours(0, 0) / exact(0, 0), exact(0, 0), 1e2 * error);
                EXPECT_LE(error, distance >= 2.0 ? far : distance == 0.0 && z > 1.0 ? of_itself : near);
            }
        }
    }
}

TEST_P(GaussianLoadIn, IsMindlinsPointLoadFarAway) {
    const double nu = GetParam();
    const MindlinKernel point(nu, 1e-9);
    for (const double deviation : {0.1, 0.05, 0.025}) {
        const Vector3 x(0.3, -0.5, -1.2), y(2.0, 0.4, -0.7);
        const Matrix3 exact = point(x, y);
        const double error = (response(nu, {x, deviation}, {y, deviation}) - exact).norm() / exact.norm();
        constexpr double second_order = 2.0;    // error/(σ/R)²; measured 0.8 at most
        EXPECT_LE(error, second_order * deviation * deviation / (x - y).squaredNorm());
    }
}

TEST_P(GaussianLoadIn, IsReciprocal) {
    const double nu = GetParam();
    constexpr double rounding = 1e-14;
    const GaussianLoad a({0.1, 0.2, -0.3}, 0.4), b({-0.3, 0.5, -1.1}, 0.7);
    EXPECT_LE((response(nu, a, b) - response(nu, b, a).transpose()).norm(), rounding * response(nu, a, b).norm());
}

TEST_P(GaussianLoadIn, HasNoSeamWhereItsSeriesEnds) {
    const double nu = GetParam();
    const GaussianLoad a({0.0, 0.0, -5.0}, 1.0);
    const double seam = std::sqrt(1e-2 * 2.0 * a.variance);    // [m] where R²/s² is a hundredth
    constexpr double rounding = 1e-11;
    for (const Vector3& way : {Vector3(1.0, 0.0, 0.0), Vector3(0.6, 0.0, 0.8)}) {
        const auto at = [&](double r) { return response(nu, GaussianLoad(Vector3(0.0, 0.0, -5.0) + r * way, 1.0), a); };
        const double step = 1e-9 * seam;
        EXPECT_LE((at(seam + step) - at(seam - step)).norm(), 2.0 * step * at(0.0).norm() + rounding * at(0.0).norm());
    }
}

}    // namespace
}    // namespace stylet::corotational_fem
