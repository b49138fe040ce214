#include "rectangle.h"

#include <stylet/mindlin_kernel.h>

#include <boost/math/quadrature/gauss.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <vector>

namespace stylet::half_space {
namespace {

using std::numbers::pi;

constexpr double radius = 0.3e-3;     // [m] of the needle whose blur is felt
constexpr double rounding = 1e-13;    // relative: a dozen operations

/// The mean of a function over a rectangle, by Gauss's rule on pieces that shrink towards the lines x = 0 and y = 0 through
/// `focus`: where an integrand has a kink there, the pieces end at it.
template <class Function>
Matrix3 mean_over(const Rectangle& rectangle, const Vector3& focus, Function function) {
    using Gauss = boost::math::quadrature::gauss<double, 15>;
    const auto pieces_of = [](double from, double to, double at) {
        std::vector<double> cuts{from, to};
        for (double way = to - from; way > 1e-7 * (to - from); way *= 0.4) {
            for (const double cut : {at - way, at, at + way}) {
                if (cut > from && cut < to) cuts.push_back(cut);
            }
        }
        std::ranges::sort(cuts);
        return cuts;
    };
    const auto along = [&](double middle, double half, double at, auto f) {
        const std::vector<double> cuts = pieces_of(middle - half, middle + half, at);
        Matrix3 sum = Matrix3::Zero();
        for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
            const double m = 0.5 * (cuts[i] + cuts[i + 1]), h = 0.5 * (cuts[i + 1] - cuts[i]);
            for (std::size_t k = 0; k < Gauss::abscissa().size(); ++k) {
                const double x = h * Gauss::abscissa()[k], weight = h * Gauss::weights()[k];
                sum += weight * f(m + x);
                if (x != 0.0) sum += weight * f(m - x);
            }
        }
        return Matrix3(sum / (2.0 * half));
    };
    return along(rectangle.x, rectangle.half_x, focus.x(), [&](double x) {
        return along(rectangle.y, rectangle.half_y, focus.y(), [&](double y) { return function(Vector3(x, y, 0.0)); });
    });
}

class HalfSpaceRectangle : public testing::TestWithParam<double> {};
INSTANTIATE_TEST_SUITE_P(PoissonRatios, HalfSpaceRectangle, testing::Values(0.0, 0.3, 0.49));

constexpr Rectangle plate{.x = 2e-3, .y = -1e-3, .half_x = 10.5e-3, .half_y = 7e-3};
constexpr double accuracy = 1e-6;      // relative: what is promised of a loaded patch
constexpr double quadrature = 1e-9;    // relative: fifteen points on pieces that shrink tenfold towards what is near

TEST_P(HalfSpaceRectangle, MovesAPointByTheMeanOfTheKernel) {
    const MindlinKernel kernel(GetParam(), radius);
    double worst = 0.0;
    for (const Vector3& x : {Vector3(2e-3, -1e-3, 0.0), Vector3(4e-3, 2e-3, -5e-3), Vector3(12.5e-3, 6e-3, -1e-4),
                             Vector3(12.5e-3, 0.0, 0.0), Vector3(-50e-3, 30e-3, 0.0), Vector3(2e-3, 0.0, -50e-3)}) {
        const Matrix3 mean = mean_over(plate, x, [&](const Vector3& source) { return kernel(x, source); });
        worst = std::max(worst, (response(GetParam(), plate, x, kernel.blur()) - mean).norm() / mean.norm());
    }
    std::printf("rectangle on a point, nu %.2f: %.1e off quadrature\n", GetParam(), worst);
    EXPECT_LE(worst, quadrature);
}

TEST_P(HalfSpaceRectangle, MovesAnotherByTheMeanOfBoth) {
    double worst = 0.0;
    for (const Rectangle& moved : {Rectangle{50e-3, 20e-3, 4e-3, 10e-3}, Rectangle{-3e-3, 30e-3, 20e-3, 3e-3},
                                   Rectangle{23e-3, -1e-3, 10.5e-3, 7e-3}, Rectangle{5e-3, 2e-3, 20e-3, 4e-3}, plate}) {
        // Kinks lie along all four sides of the loaded one: each quarter of the moved one that they cut looks at its corner.
        Matrix3 mean = Matrix3::Zero();
        const auto cut = [](double middle, double half, double at) {
            const double edge = std::clamp(at, middle - half, middle + half);
            return std::array{std::pair{0.5 * (middle - half + edge), 0.5 * (edge - middle + half)},
                              std::pair{0.5 * (edge + middle + half), 0.5 * (middle + half - edge)}};
        };
        for (const auto& [x, half_x] : cut(moved.x, moved.half_x, plate.x)) {
            for (const auto& [y, half_y] : cut(moved.y, moved.half_y, plate.y)) {
                const Rectangle part{x, y, half_x, half_y};
                if (part.area() == 0.0) continue;
                const Vector3 corner(plate.x + std::copysign(plate.half_x, x - plate.x),
                                     plate.y + std::copysign(plate.half_y, y - plate.y), 0.0);
                mean += part.area() / moved.area() *
                        mean_over(part, corner, [](const Vector3& at) { return response(GetParam(), plate, at, 0.0); });
            }
        }
        const Matrix3 found = mean_response(GetParam(), plate, moved);
        worst = std::max(worst, (found - mean).norm() / mean.norm());
        EXPECT_LE((found - mean_response(GetParam(), moved, plate).transpose()).norm(), rounding * found.norm());
    }
    std::printf("rectangle on a rectangle, nu %.2f: %.1e off quadrature\n", GetParam(), worst);
    EXPECT_LE(worst, accuracy);
}

TEST_P(HalfSpaceRectangle, FromFarAwayIsBoussinesqsPoint) {
    const double nu = GetParam();
    constexpr double side = 2e-3;
    for (const double r : {0.1, 0.2, 0.4}) {
        const Rectangle small{.x = 0.0, .y = 0.0, .half_x = 0.5 * side, .half_y = 0.5 * side};
        const Rectangle other{.x = r, .y = 0.0, .half_x = 0.5 * side, .half_y = 0.5 * side};
        const double point = (1.0 - nu * nu) / (pi * r);
        const double on_point = response(nu, small, {r, 0.0, 0.0}, 0.0)(2, 2) / point;
        const double on_other = mean_response(nu, small, other)(2, 2) / point;
        std::printf("squares %g of their sides apart, nu %.2f: %.4e off Boussinesq\n", r / side, nu, on_other - 1.0);
        // A square's second moments, side²/12 each way, add half of that times ∇²(1/r) = 1/r³; what follows is of fourth order.
        const double second = side * side / (24.0 * r * r), fourth = std::pow(side / r, 4);
        EXPECT_NEAR(on_point - 1.0, second, fourth + 1e-11);
        EXPECT_NEAR(on_other - 1.0, 2.0 * second, fourth + 1e-9);
    }
}

TEST_P(HalfSpaceRectangle, IsFiniteAtItsCornersEdgesAndEverywhereElse) {
    for (const double x : {plate.x, plate.x + plate.half_x, plate.x - plate.half_x, 0.3}) {
        for (const double y : {plate.y, plate.y + plate.half_y, plate.y - plate.half_y, -0.3}) {
            for (const double z : {1e-3, 0.0, -1e-15, -1e-3, -0.15}) {
                EXPECT_TRUE(response(GetParam(), plate, {x, y, z}, 0.0).allFinite()) << x << ' ' << y << ' ' << z;
            }
        }
    }
}

}    // namespace
}    // namespace stylet::half_space
