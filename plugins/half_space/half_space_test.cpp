#include "kernel.h"
#include "rectangle.h"

#include <stylet/contract/allocations.h>
#include <stylet/contract/contract.h>
#include <stylet/tissue_model.h>

#include <boost/math/quadrature/gauss.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numbers>
#include <random>

namespace stylet {
namespace {

using contract::Case;
using half_space::Kernel;
using half_space::Rectangle;
using std::numbers::pi;

TissueSetup two_layers() {
    TissueSetup tissue = contract::gel_block();
    tissue.layers.insert(tissue.layers.begin(), {.name = "skin",
                                                 .youngs_modulus = 60e3,
                                                 .poisson_ratio = tissue.layers.front().poisson_ratio,
                                                 .density = std::numeric_limits<double>::quiet_NaN(),
                                                 .thickness = 5e-3});
    return tissue;
}

STYLET_CONTRACT(Case{.name = "Gel"}, Case{.name = "HardPush", .load = 2.0, .lateral = 0.3},
                Case{.name = "TwoLayers", .tissue = two_layers()})

constexpr double radius = 0.3e-3;     // [m]
constexpr double rounding = 1e-13;    // relative: a dozen operations
const Vector3 surface = Vector3::Zero();

double shear_modulus(double nu) {
    return 1.0 / (2.0 * (1.0 + nu));
}    // of E = 1

class HalfSpaceKernel : public testing::TestWithParam<double> {};
INSTANTIATE_TEST_SUITE_P(PoissonRatios, HalfSpaceKernel, testing::Values(0.0, 0.3, 0.49));

TEST_P(HalfSpaceKernel, OnTheSurfaceIsTheRigidPunch) {
    const double nu = GetParam(), G = shear_modulus(nu);
    const Matrix3 u = Kernel(nu, radius)(surface, surface);
    const double axial = (1.0 - nu * nu) / (2.0 * radius), lateral = (2.0 - nu) / (8.0 * G * radius);
    EXPECT_NEAR(u(2, 2) / axial, 1.0, rounding);
    EXPECT_NEAR(u(0, 0) / lateral, 1.0, rounding);
    EXPECT_NEAR(u(1, 1) / lateral, 1.0, rounding);
}

TEST_P(HalfSpaceKernel, DeepInsideIsSelvaduraisEmbeddedDisc) {
    const double nu = GetParam(), G = shear_modulus(nu);
    const Vector3 deep(0.0, 0.0, -100.0 * radius);
    const double disc = (3.0 - 4.0 * nu) / (32.0 * G * (1.0 - nu) * radius);
    // The surface's share falls with a/c; at a hundred radii it is below one per cent.
    constexpr double of_the_surface = 1e-2;
    const double ratio = Kernel(nu, radius)(deep, deep)(2, 2) / disc;
    std::printf("embedded disc, nu %.2f: %.5f of Selvadurai's\n", nu, ratio);
    EXPECT_NEAR(ratio, 1.0, of_the_surface);
}

TEST_P(HalfSpaceKernel, FarAwayIsBoussinesqAndKelvin) {
    const double nu = GetParam(), G = shear_modulus(nu);
    const Kernel kernel(nu, radius);
    const double r = 5e-3;
    // The blur b = 2a/π moves the source by b at right angles to the way: O(b²/r²) on the surface, O(b/r) along the axis.
    const double b = 2.0 * radius / pi;
    EXPECT_NEAR(kernel({r, 0.0, 0.0}, surface)(2, 2) * pi * r / (1.0 - nu * nu), 1.0, b * b / (r * r));
    const Vector3 source(0.0, 0.0, -1.0), below(0.0, 0.0, -1.0 - r);
    const double kelvin = 4.0 * (1.0 - nu) / (16.0 * pi * G * (1.0 - nu) * r);
    EXPECT_NEAR(kernel(below, source)(2, 2) / kelvin, 1.0, 2.0 * b / r);
}

// Stress at x for a unit force j at the source, by central differences.
Matrix3 stress(const Kernel& kernel, double nu, const Vector3& x, const Vector3& source, int j) {
    constexpr double h = 1e-7;
    const double G = shear_modulus(nu), lame = 2.0 * G * nu / (1.0 - 2.0 * nu);
    Matrix3 gradient;
    for (int i = 0; i < 3; ++i) {
        const Vector3 step = h * Vector3::Unit(i);
        gradient.col(i) = (kernel(x + step, source).col(j) - kernel(x - step, source).col(j)) / (2.0 * h);
    }
    return G * (gradient + gradient.transpose()) + lame * gradient.trace() * Matrix3::Identity();
}

TEST_P(HalfSpaceKernel, IsInEquilibriumAwayFromTheSource) {
    const double nu = GetParam(), h = 2e-6;
    const Kernel kernel(nu, radius);
    const Vector3 source(0.1e-3, 0.2e-3, -1e-3), x(0.9e-3, -0.5e-3, -0.6e-3);
    for (int j = 0; j < 3; ++j) {
        Vector3 divergence = Vector3::Zero();
        for (int i = 0; i < 3; ++i) {
            const Vector3 step = h * Vector3::Unit(i);
            divergence += (stress(kernel, nu, x + step, source, j) - stress(kernel, nu, x - step, source, j)).col(i) / (2.0 * h);
        }
        const double scale = stress(kernel, nu, x, source, j).norm() / 1e-3;    // a stress over the distance to the source
        // Two nested central differences: (h/r)² ≈ 4e-6 of truncation and 1e-16/(1e-7·2e-6)·r² ≈ 1e-4 of rounding.
        constexpr double differences = 1e-3;
        EXPECT_LE(divergence.norm(), differences * scale) << "force " << j;
    }
}

TEST_P(HalfSpaceKernel, LeavesTheSurfaceFree) {
    const double nu = GetParam();
    const Kernel kernel(nu, radius);
    const Vector3 source(0.0, 0.0, -1e-3);
    for (int j = 0; j < 3; ++j) {
        // A point must be inside for its differences: its traction falls linearly to zero with the depth.
        const double at_1 = stress(kernel, nu, {0.7e-3, 0.4e-3, -1e-6}, source, j).col(2).norm();
        const double at_10 = stress(kernel, nu, {0.7e-3, 0.4e-3, -1e-5}, source, j).col(2).norm();
        const double inside = stress(kernel, nu, {0.7e-3, 0.4e-3, -1e-3}, source, j).norm();
        EXPECT_LE(at_1, 1e-2 * inside) << "force " << j;
        EXPECT_LE(at_1, 0.15 * at_10 + 1e-6 * inside) << "force " << j;
    }
}

TEST_P(HalfSpaceKernel, VerticalShortcutIsTheSameFunction) {
    const Kernel kernel(GetParam(), radius);
    for (const double z : {0.0, -1e-3, -7e-3}) {
        for (const double c : {0.0, -1e-3, -20e-3}) {
            const Matrix3 on = kernel({0.0, 0.0, z}, {0.0, 0.0, c}), beside = kernel({1e-10, 0.0, z}, {0.0, 0.0, c});
            // Moving the point aside by x changes u by O(x/R), R at least the blur.
            EXPECT_LE((on - beside).norm(), 1e-6 * on.norm());
        }
    }
}

TEST_P(HalfSpaceKernel, IsReciprocalAndPositiveDefinite) {
    const Kernel kernel(GetParam(), radius);
    std::mt19937 random(7);
    std::uniform_real_distribution<double> across(-5e-3, 5e-3), down(-10e-3, 0.0);
    constexpr int count = 30;
    std::vector<Vector3> points;
    for (int i = 0; i < count; ++i) points.emplace_back(across(random), across(random), down(random));
    MatrixX all(3 * count, 3 * count);
    for (int i = 0; i < count; ++i) {
        for (int j = 0; j < count; ++j) all.block<3, 3>(3 * i, 3 * j) = kernel(points[i], points[j]);
    }
    EXPECT_LE((all - all.transpose()).norm(), rounding * all.norm());
    const VectorX eigenvalues = all.selfadjointView<Eigen::Lower>().eigenvalues();
    std::printf("30 random points, nu %.2f: eigenvalues from %.3g to %.3g m/N per 1/Pa\n", GetParam(), eigenvalues.minCoeff(),
                eigenvalues.maxCoeff());
    EXPECT_GT(eigenvalues.minCoeff(), 0.0);
}

TEST(HalfSpace, CaseStudyPunchIsTwentyNewtonsAMetre) {
    const double E = 25e3, nu = 0.49;
    const double stiffness = E / Kernel(nu, radius)(surface, surface)(2, 2);
    std::printf("case study: %.3f N/m axial, %.3f N/m lateral\n", stiffness, E / Kernel(nu, radius)(surface, surface)(0, 0));
    EXPECT_NEAR(stiffness, 19.74, 0.005);    // 2aE*, validation.md, last paragraph of Solids
}

TEST(HalfSpace, PointLoadOfTheTable) {
    // validation.md: 1.935 mm at r = 5 mm for 1 N on E = 25 kPa, ν = 0.49; four digits are printed there.
    const double u = Kernel(0.49, radius)({5e-3, 0.0, 0.0}, surface)(2, 2) / 25e3;
    std::printf("point load: %.4f mm\n", 1e3 * u);
    EXPECT_NEAR(1e3 * u, 1.935, 0.002);
}

std::unique_ptr<TissueModel> make(const Case& with) {
    return contract::make<TissueModel>(STYLET_PLUGIN_FILE, with);
}

TEST(HalfSpace, InterfaceBelongsToTheLayerBelow) {
    const Case layered{.name = "layered", .tissue = two_layers()};
    const auto tissue = make(layered);
    const double z = -5e-3;
    EXPECT_EQ(tissue->locate({0.0, 0.0, z}).layer, 1);
    EXPECT_EQ(tissue->locate({0.0, 0.0, std::nextafter(z, 0.0)}).layer, 0);
    EXPECT_EQ(tissue->locate({0.0, 0.0, std::nextafter(z, -1.0)}).layer, 1);
    EXPECT_EQ(tissue->locate({0.0, 0.0, 1e-3}).layer, outside);
    EXPECT_EQ(tissue->locate({0.0, 0.0, -layered.tissue.extent.z() - 1e-3}).layer, outside);
}

TEST(HalfSpace, IsEnteredThroughItsSurfaceOnly) {
    const Case gel{.name = "gel"};
    const auto tissue = make(gel);
    EXPECT_NEAR(tissue->entry({0.0, 0.0, 3e-3}, {0.0, 0.0, -1e-3}), 0.75, rounding);
    EXPECT_EQ(tissue->entry({0.0, 0.0, 0.0}, {0.0, 0.0, -1e-12}), 0.0);
    EXPECT_LT(tissue->entry({0.0, 0.0, -1e-3}, {0.0, 0.0, -2e-3}), 0.0) << "inside already";
    EXPECT_LT(tissue->entry({0.0, 0.0, -1e-3}, {0.0, 0.0, 1e-3}), 0.0) << "on the way out";
    EXPECT_LT(tissue->entry({1.0, 0.0, 1e-3}, {1.0, 0.0, -1e-3}), 0.0) << "beside the block";
}

TEST(HalfSpace, SaysWhenTheDentIsDeeperThanTheBlock) {
    const Case gel{.name = "gel"};
    const auto tissue = make(gel);
    const ContactPoint tip{.material = surface, .span = Vector3::Zero(), .arclength = 0.2, .tip = true};
    const double limit = gel.tissue.extent.z() * gel.tissue.layers.front().youngs_modulus /
                         Kernel(gel.tissue.layers.front().poisson_ratio, gel.needle.radius)(surface, surface)(2, 2);
    for (const double share : {0.99, 1.01}) {
        const VectorX force = (VectorX(3) << 0.0, 0.0, -share * limit).finished();
        (void)tissue->try_step({&tip, 1}, {force.data(), 3});
        tissue->commit();
        EXPECT_EQ(tissue->beyond_validity() != nullptr, share > 1.0);
    }
}

TEST(HalfSpace, RefusesLayersOfDifferentPoissonRatios) {
    Case mixed{.name = "mixed", .tissue = two_layers()};
    mixed.tissue.layers.front().poisson_ratio = 0.3;
    EXPECT_THROW(make(mixed), Error);
}

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
constexpr double accuracy = 1e-6;      // relative: what closed form and quadrature may differ by, the loaded patch's promise
constexpr double quadrature = 1e-9;    // relative: fifteen points on pieces that shrink tenfold towards what is near

TEST_P(HalfSpaceRectangle, MovesAPointByTheMeanOfTheKernel) {
    const Kernel kernel(GetParam(), radius);
    double worst = 0.0;
    for (const Vector3& x : {Vector3(2e-3, -1e-3, 0.0), Vector3(4e-3, 2e-3, -5e-3), Vector3(12.5e-3, 6e-3, -1e-4),
                             Vector3(12.5e-3, 0.0, 0.0), Vector3(-50e-3, 30e-3, 0.0), Vector3(2e-3, 0.0, -50e-3)}) {
        const Matrix3 mean = mean_over(plate, x, [&](const Vector3& source) { return kernel(x, source); });
        worst = std::max(worst, (half_space::response(GetParam(), plate, x, kernel.blur()) - mean).norm() / mean.norm());
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
                mean += part.area() / moved.area() * mean_over(part, corner, [](const Vector3& at) {
                            return half_space::response(GetParam(), plate, at, 0.0);
                        });
            }
        }
        const Matrix3 found = half_space::mean_response(GetParam(), plate, moved);
        worst = std::max(worst, (found - mean).norm() / mean.norm());
        EXPECT_LE((found - half_space::mean_response(GetParam(), moved, plate).transpose()).norm(), rounding * found.norm());
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
        const double on_point = half_space::response(nu, small, {r, 0.0, 0.0}, 0.0)(2, 2) / point;
        const double on_other = half_space::mean_response(nu, small, other)(2, 2) / point;
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
                EXPECT_TRUE(half_space::response(GetParam(), plate, {x, y, z}, 0.0).allFinite()) << x << ' ' << y << ' ' << z;
            }
        }
    }
}

constexpr double gel_modulus = 25e3, gel_ratio = 0.49;    // [Pa], 1: contract::gel_block()

Patch square(double x, double y, double side) {
    return {.centre = {x, y, 0.0}, .size = {side, side, 0.0}};
}

/// A block without a needle whose patches are loaded at once.
struct LoadedBlock {
    LoadedBlock(const Case& with, std::vector<Patch> where, std::vector<Vector3> forces) : patches(std::move(where)) {
        tissue = make(with);
        tissue->bear(patches);
        tissue->load(forces);
        tissue->predict(1e-3);
        (void)tissue->try_step({}, {nullptr, 0});
        tissue->commit();
    }
    std::vector<Patch> patches;
    std::unique_ptr<TissueModel> tissue;
};

const Case without_needle{.name = "without_needle", .has_needle = false};
const Vector3 newton_down(0.0, 0.0, -1.0);

TEST(HalfSpacePatch, ASquareSinksAsLoveAndTimoshenkoSay) {
    constexpr double side = 21e-3;
    const LoadedBlock block(without_needle, {square(0.0, 0.0, side)}, {newton_down});
    const double unit = (1.0 - gel_ratio * gel_ratio) / (gel_modulus * side);
    const double mean = -block.tissue->patch_displacement(0).z() / unit;
    const double centre = -block.tissue->displacement(Vector3::Zero()).z() / unit;
    const double corner = -block.tissue->displacement({0.5 * side, 0.5 * side, 0.0}).z() / unit;
    std::printf("21 mm square, 1 N: mean %.4f mm = %.5f, centre %.5f, corner %.5f of F(1 - nu^2)/(E s)\n", 1e3 * mean * unit,
                mean, centre, corner);
    constexpr double printed = 0.005;    // Timoshenko and Goodier print 0.95, 1.12 and half of that
    EXPECT_NEAR(mean, 0.95, printed);
    EXPECT_NEAR(centre, 1.12, printed);
    const double loves_centre = 4.0 / pi * std::log(1.0 + std::sqrt(2.0));
    const double loves_mean = 4.0 / pi * (std::log(1.0 + std::sqrt(2.0)) + (1.0 - std::sqrt(2.0)) / 3.0);
    EXPECT_NEAR(centre, loves_centre, accuracy);
    EXPECT_NEAR(corner, 0.5 * loves_centre, accuracy);
    EXPECT_NEAR(mean, loves_mean, accuracy);
}

TEST(HalfSpacePatch, ADiscOfSquaresSinksAsACircle) {
    // Timoshenko and Goodier: a circle of uniform pressure sinks by 16/(3π) p a (1 − ν²)/E on average; of a force and an area:
    constexpr double disc = 16.0 / (3.0 * pi * 1.7724538509055159);    // of F(1 − ν²)/(E √A)
    constexpr double disc_radius = 20e-3;
    double before = 1.0;
    for (const int across : {5, 10, 20}) {
        const double side = 2.0 * disc_radius / across;
        std::vector<Patch> tiles;
        for (int i = 0; i < across; ++i) {
            for (int j = 0; j < across; ++j) {
                const double x = (i + 0.5) * side - disc_radius, y = (j + 0.5) * side - disc_radius;
                if (std::hypot(x, y) <= disc_radius) tiles.push_back(square(x, y, side));
            }
        }
        const double count = static_cast<double>(tiles.size());
        const LoadedBlock block(without_needle, tiles, std::vector<Vector3>(tiles.size(), newton_down / count));
        double mean = 0.0;
        for (int i = 0; i < static_cast<int>(tiles.size()); ++i) mean -= block.tissue->patch_displacement(i).z() / count;
        const double unit = (1.0 - gel_ratio * gel_ratio) / (gel_modulus * std::sqrt(count) * side);
        const double error = std::abs(mean / unit / disc - 1.0);
        std::printf("disc of %zu squares: %.5f, a circle %.5f of F(1 - nu^2)/(E sqrt(A))\n", tiles.size(), mean / unit, disc);
        EXPECT_LT(error, before);
        before = error;
    }
    constexpr double steps = 2e-3;    // of the answer: an outline of steps instead of a circle
    EXPECT_LT(before, steps);
}

TEST(HalfSpacePatch, APartMovesLikeItsWhole) {
    constexpr double side = 20e-3;
    const std::vector<Patch> parts{square(-5e-3, -5e-3, 10e-3), square(5e-3, -5e-3, 10e-3), square(-5e-3, 5e-3, 10e-3),
                                   square(5e-3, 5e-3, 10e-3)};
    for (const Vector3& force : {Vector3(0.0, 0.0, -1.0), Vector3(1.0, 0.0, 0.0), Vector3(0.3, -0.2, -1.0)}) {
        const LoadedBlock whole(without_needle, {square(0.0, 0.0, side)}, {force});
        const LoadedBlock split(without_needle, parts, std::vector<Vector3>(4, 0.25 * force));
        Vector3 mean = Vector3::Zero();
        for (int i = 0; i < 4; ++i) mean += 0.25 * split.tissue->patch_displacement(i);
        EXPECT_LE((mean - whole.tissue->patch_displacement(0)).norm(), 1e-12 * mean.norm()) << force.transpose();
        EXPECT_NEAR(split.tissue->energy().stored / whole.tissue->energy().stored, 1.0, 1e-12);
    }
}

/// A tissue with two patches, a tip and a piece of shaft, all loaded.
struct Pushed {
    Pushed() {
        tissue->bear(patches);
        tissue->load(loads);
    }
    /// Takes a share of the patches' loads and another of the contacts' forces.
    void take(double of_loads, double of_forces) {
        const std::vector<Vector3> now{of_loads * loads[0], of_loads * loads[1]};
        tissue->load(now);
        tissue->predict(1e-3);
        scaled = of_forces * forces;
        (void)tissue->linearise(points, 0.0);
        (void)tissue->try_step(points, {scaled.data(), scaled.size()});
        tissue->commit();
    }
    VectorX contacts_moved() {
        const Linearisation now = tissue->linearise(points, 0.0);
        VectorX moved = now.free + now.compliance * scaled;
        for (std::size_t i = 0; i < points.size(); ++i) moved.segment<3>(3 * static_cast<Eigen::Index>(i)) -= points[i].material;
        return moved;
    }
    VectorX patches_moved() {
        VectorX moved(6);
        moved << tissue->patch_displacement(0), tissue->patch_displacement(1);
        return moved;
    }

    Case gel{.name = "gel"};
    std::unique_ptr<TissueModel> tissue = make(gel);
    std::vector<Patch> patches{square(4e-3, 0.0, 10e-3), {.centre = {-6e-3, 9e-3, 0.0}, .size = {8e-3, 3e-3, 0.0}}};
    std::vector<Vector3> loads{{0.2, -0.1, -1.0}, {-0.3, 0.4, 0.5}};
    std::vector<ContactPoint> points{{.material = {0.0, 0.0, -8e-3}, .span = Vector3::Zero(), .arclength = 0.2, .tip = true},
                                     {.material = Vector3::Zero(), .span = {0.0, 0.0, -5e-3}, .arclength = 0.192, .tip = false}};
    VectorX forces = (VectorX(6) << 0.01, 0.02, -0.3, -0.01, 0.03, -0.05).finished();
    VectorX scaled = VectorX::Zero(6);
};

constexpr double of_sums = 1e-12;    // relative: a few hundred roundings, and 1e-9 of a shaft's own compliance (independence)

TEST(HalfSpacePatch, LoadsAndContactsAddUp) {
    Pushed loads, forces, both;
    loads.take(1.0, 0.0);
    forces.take(0.0, 1.0);
    both.take(1.0, 1.0);
    const VectorX contacts = both.contacts_moved(), patches = both.patches_moved();
    EXPECT_GT(loads.contacts_moved().norm(), 0.1 * contacts.norm()) << "the loads move the contacts";
    EXPECT_GT(forces.patches_moved().norm(), 0.01 * patches.norm()) << "the contacts move the patches";
    EXPECT_LE((loads.contacts_moved() + forces.contacts_moved() - contacts).norm(), of_sums * contacts.norm());
    EXPECT_LE((loads.patches_moved() + forces.patches_moved() - patches).norm(), of_sums * patches.norm());
    for (const Vector3& x : {Vector3(0.0, 0.0, -8e-3), Vector3(4e-3, 0.0, 0.0), Vector3(0.05, 0.02, -0.03)}) {
        const Vector3 sum = loads.tissue->displacement(x) + forces.tissue->displacement(x);
        EXPECT_LE((both.tissue->displacement(x) - sum).norm(), of_sums * sum.norm());
    }
}

TEST(HalfSpacePatch, LoadsWorkOnContactsWhatContactsWorkOnLoads) {
    Pushed loads, forces;
    loads.take(1.0, 0.0);
    forces.take(0.0, 1.0);
    VectorX on_patches(6);
    on_patches << loads.loads[0], loads.loads[1];
    const double one = loads.contacts_moved().dot(forces.forces), other = forces.patches_moved().dot(on_patches);
    std::printf("Betti: %.9g and %.9g mJ\n", 1e3 * one, 1e3 * other);
    EXPECT_NEAR(one / other, 1.0, of_sums);
}

TEST(HalfSpacePatch, EnergyIsTheWorkOfLoadsAndContacts) {
    Pushed block;
    VectorX on_patches(6);
    on_patches << block.loads[0], block.loads[1];
    double work = 0.0, old_loads = 0.0;
    VectorX contacts = VectorX::Zero(6), patches = VectorX::Zero(6), old_forces = VectorX::Zero(6);
    for (int i = 1; i <= 20; ++i) {    // loads and forces rise and fall, not together
        const double of_loads = std::sin(0.3 * i), of_forces = std::sin(0.13 * i);
        block.take(of_loads, of_forces);
        const VectorX now = block.contacts_moved(), then = block.patches_moved();
        work += 0.5 * (old_forces + of_forces * block.forces).dot(now - contacts);
        work += 0.5 * (old_loads + of_loads) * on_patches.dot(then - patches);
        contacts = now;
        patches = then;
        old_loads = of_loads;
        old_forces = of_forces * block.forces;
    }
    std::printf("stored %.9g mJ, worked %.9g mJ\n", 1e3 * block.tissue->energy().stored, 1e3 * work);
    EXPECT_NEAR(block.tissue->energy().stored / work, 1.0, of_sums);
}

TEST(HalfSpacePatch, IsPositiveDefiniteTogetherWithContacts) {
    // A force on a patch against the same on a contact in its middle: the mean of a patch of the needle's size moves much less
    // than the contact, and nearly nothing is left of the pair's energy if the kernels of the two don't fit.
    for (const double side : {0.1e-3, 0.3e-3, 0.53e-3, 1e-3, 5e-3}) {
        for (const double depth : {0.0, 0.1e-3, 1e-3}) {
            const Case gel{.name = "gel"};
            const auto tissue = make(gel);
            const Patch patch = square(0.0, 0.0, side);
            tissue->bear({&patch, 1});
            const ContactPoint tip{.material = {0.0, 0.0, -depth}, .span = Vector3::Zero(), .arclength = 0.2, .tip = true};
            MatrixX all(6, 6);
            for (int j = 0; j < 6; ++j) {
                const VectorX unit = VectorX::Unit(6, j), force = unit.tail(3);
                const Vector3 load = unit.head(3);
                tissue->load({&load, 1});
                tissue->predict(1e-3);
                (void)tissue->try_step({&tip, 1}, {force.data(), 3});
                const Linearisation now = tissue->linearise({&tip, 1}, 0.0);
                all.col(j) << tissue->patch_displacement(0), now.free + now.compliance * force - tip.material;
            }
            EXPECT_LE((all - all.transpose()).norm(), 1e-9 * all.norm());
            EXPECT_GT(all.selfadjointView<Eigen::Lower>().eigenvalues().minCoeff(), 0.0) << side << " m, " << depth << " m deep";
        }
    }
}

TEST(HalfSpacePatch, ShowsATipWhereTheTipIs) {
    Pushed block;
    block.points.resize(1);
    block.points[0].material.setZero();
    block.forces.conservativeResize(3);
    block.take(1.0, 1.0);
    const Vector3 shown = block.tissue->displacement(block.points[0].material);
    std::printf("tip of 0.3 N beside two patches: moved %.4f mm\n", 1e3 * shown.norm());
    // 1e-9: a contact is that much softer in its own place (independence).
    EXPECT_LE((shown - block.contacts_moved()).norm(), 2e-9 * shown.norm());
}

TEST(HalfSpacePatch, ALoadActsFromTheNextPredictOnAndIsTakenBack) {
    const std::vector<Patch> patches{square(0.0, 0.0, 10e-3)};
    const auto tissue = make(without_needle);
    const auto settle = [&tissue] {
        (void)tissue->try_step({}, {nullptr, 0});
        return tissue->patch_displacement(0).z();
    };
    tissue->bear(patches);
    tissue->load({&newton_down, 1});
    EXPECT_EQ(settle(), 0.0) << "not before predict";
    tissue->predict(1e-3);
    const double once = settle();
    EXPECT_LT(once, 0.0);
    tissue->commit();
    const Vector3 more = 3.0 * newton_down;
    tissue->load({&more, 1});
    tissue->predict(1e-3);
    EXPECT_NEAR(settle() / once, 3.0, rounding);
    tissue->rollback();
    EXPECT_EQ(tissue->patch_displacement(0).z(), once);
    tissue->predict(0.0);
    EXPECT_EQ(settle(), once) << "a load that was taken back acts again";
}

TEST(HalfSpacePatch, HasTheModulusOfTheTopLayer) {
    Case layered = without_needle;
    layered.tissue = two_layers();
    const LoadedBlock soft(without_needle, {square(0.0, 0.0, 21e-3)}, {newton_down});
    const LoadedBlock hard(layered, {square(0.0, 0.0, 21e-3)}, {newton_down});
    EXPECT_NEAR(soft.tissue->patch_displacement(0).z() / hard.tissue->patch_displacement(0).z(), 60e3 / 25e3, rounding);
    EXPECT_TRUE(hard.tissue->displacement({0.0, 0.0, -5e-3}).allFinite()) << "on the interface";
}

TEST(HalfSpacePatch, SaysWhenItSinksDeeperThanTheBlock) {
    const double limit = 0.15 / (0.946402 * (1.0 - gel_ratio * gel_ratio) / (gel_modulus * 21e-3));    // [N]
    for (const double share : {0.99, 1.01}) {
        const LoadedBlock block(without_needle, {square(0.0, 0.0, 21e-3)}, {share * limit * newton_down});
        EXPECT_EQ(block.tissue->beyond_validity() != nullptr, share > 1.0);
    }
}

TEST(HalfSpacePatch, ATickAllocatesNothing) {
    Pushed block;
    block.take(0.1, 0.1);
    const std::vector<Vector3> loads = block.loads;
    const std::size_t before = contract::allocations();
    for (int i = 0; i < 3; ++i) {
        block.points[1].span.z() -= 1e-3;    // a growing contact meets the patches anew
        block.tissue->load(loads);
        block.tissue->predict(1e-3);
        (void)block.tissue->linearise(block.points, 0.0);
        (void)block.tissue->try_step(block.points, {block.forces.data(), block.forces.size()});
        (void)block.tissue->patch_displacement(1);
        if (i == 1) block.tissue->rollback();
        block.tissue->commit();
        (void)block.tissue->displacement({1e-3, 0.0, -2e-3});
    }
    EXPECT_EQ(contract::allocations() - before, 0U);
}

std::string refusal(const Patch& patch, const std::string& key) {
    const auto tissue = make(without_needle);
    try {
        tissue->bear({&patch, 1});
    } catch (const Error& error) {
        EXPECT_EQ(error.key(), key);
        return error.what();
    }
    return "accepted";
}

TEST(HalfSpacePatch, IsRefusedWhereItIsNoRectangleOnTheTop) {
    EXPECT_EQ(refusal({.centre = {0.0, 0.0, 0.0}, .size = {0.02, 0.02, 1e-3}}, "size"),
              "found a height of 0.001 m, wanted 0 m: half_space bears loads on its top alone");
    EXPECT_EQ(refusal({.centre = {0.0, 0.0, -0.01}, .size = {0.02, 0.02, 0.0}}, "centre"),
              "found z = -0.01 m, wanted 0 m: half_space bears loads on its top alone");
    EXPECT_EQ(refusal({.centre = {0.0, 0.0, 0.0}, .size = {0.02, 0.0, 0.0}}, "size"),
              "found 0.02 m by 0 m, wanted a rectangle with sides of at least 1e-05 m");
    EXPECT_EQ(refusal({.centre = {0.191, 0.0, 0.0}, .size = {0.02, 0.02, 0.0}}, "centre"),
              "found a patch that reaches beyond the block's top of 0.4 m by 0.4 m around the origin, wanted it within");
    EXPECT_EQ(refusal({.centre = {0.19, 0.0, 0.0}, .size = {0.02, 0.02, 0.0}}, ""), "accepted");
    EXPECT_EQ(refusal({.centre = {0.0, 0.0, 0.0}, .size = {0.4, 0.4, 0.0}}, ""), "accepted");
}

TEST(HalfSpacePatch, IsRefusedAsOneOfTooMany) {
    const auto tissue = make(without_needle);
    try {
        tissue->bear(std::vector<Patch>(1001, square(0.0, 0.0, 1e-3)));
        FAIL() << "accepted";
    } catch (const Error& error) {
        EXPECT_EQ(error.key(), "effects");
        EXPECT_STREQ(error.what(), "found 1001 loaded patches, half_space bears at most 1000");
    }
}

}    // namespace
}    // namespace stylet
