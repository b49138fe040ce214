// The converged load against the differential equation itself, w⁗ + p w″ + κ w = 0, solved exactly in each piece.
#include "layered_column.h"

#include <gtest/gtest.h>

#include <unsupported/Eigen/MatrixFunctions>

#include <cstdio>
#include <random>

namespace stylet {
namespace {

using Matrix4 = Eigen::Matrix4d;

/// Takes (w, w′, w″, w‴) over a piece of length d on κ under the load p.
Matrix4 transfer(double d, double kappa, double p) {
    Matrix4 rate;
    rate << 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, -kappa, 0, -p, 0;
    return Matrix4(d * rate).exp();
}

/// Zero where the column, its length taken as 1, has a bent shape under the load p that keeps to its ends.
double determinant(const LayeredColumn& column, double p) {
    const double length = column.length(), scale = std::pow(length, 4) / LayeredColumn::bending_stiffness();
    Matrix4 whole = transfer(column.free_length / length, 0.0, p);
    for (const Bed& bed : column.beds) whole = transfer(bed.thickness / length, scale * bed.modulus, p) * whole;

    const int turning = column.ends == Ends::pinned_pinned ? 1 : 2;    // beside w‴, what the base leaves free: w′ or w″
    Eigen::Matrix<double, 4, 2> shapes;
    shapes << whole.col(turning), whole.col(3);
    Eigen::Matrix2d at_tip;
    if (column.ends == Ends::clamped_free)
        at_tip << shapes.row(2), shapes.row(3) + p * shapes.row(1);
    else
        at_tip << shapes.row(0), shapes.row(column.ends == Ends::clamped_clamped ? 1 : 2);
    return at_tip.determinant();
}

/// The smallest p > 0 with a bent shape.
double smallest_root(const LayeredColumn& column) {
    constexpr double step = 1.01;    // closer together than two loads of these columns are
    const double sign = determinant(column, 1.0);
    double above = 1.0;    // below the load of any column, π²/4
    while (determinant(column, above) * sign > 0.0) above *= step;
    double below = above / step;
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (below + above);
        (determinant(column, middle) * sign > 0.0 ? below : above) = middle;
    }
    return below;
}

TEST(Winkler, SolvesTheDifferentialEquationOfRandomColumns) {
    constexpr double elements = 2e-6;    // relative: 64 elements where l (k/EI)^¼ is up to 8
    std::mt19937 random(4);
    const auto uniform = [&random](double least, double greatest) {
        return std::uniform_real_distribution<double>(least, greatest)(random);
    };
    double worst = 0.0;
    for (int i = 0; i < 200; ++i) {
        LayeredColumn column{
            .beds = {}, .free_length = i % 2 == 0 ? 0.0 : uniform(0.001, 0.06), .ends = static_cast<Ends>(i % 4)};
        const int layers = 1 + i % 5;
        for (int layer = 0; layer < layers; ++layer)
            column.beds.push_back({uniform(0.001, 0.06) / layers, 1e3 * std::pow(300.0, uniform(0.0, 1.0))});
        const double exact = smallest_root(column) * LayeredColumn::bending_stiffness() / std::pow(column.length(), 2);
        const double off = std::abs(column.load("winkler") / exact - 1.0);
        worst = std::max(worst, off);
        EXPECT_LT(off, elements) << "column " << i;
    }
    std::printf("200 random columns: %.1e at worst\n", worst);
}

}    // namespace
}    // namespace stylet
