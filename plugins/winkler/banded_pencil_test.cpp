#include "banded_pencil.h"

#include "hermite_beam.h"

#include <Eigen/Eigenvalues>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>

namespace stylet::winkler {
namespace {

using Eigen::MatrixXd;

constexpr double tolerance = 1e-9;    // relative, asked of the eigenvalue

MatrixXd dense(BandMatrix& band, int size) {
    MatrixXd matrix = MatrixXd::Zero(size, size);
    for (int i = 0; i < size; ++i)
        for (int j = std::max(0, i - half_bandwidth); j <= i; ++j) matrix(i, j) = matrix(j, i) = band(i, j);
    return matrix;
}

/// The smallest p by a dense solver. K is the positive definite one, so the problem is turned round: G x = (1/p) K x.
double dense_smallest(BandedPencil& pencil, int size) {
    const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> solver(dense(pencil.geometric, size), dense(pencil.stiffness, size),
                                                                    Eigen::EigenvaluesOnly);
    return 1.0 / solver.eigenvalues().maxCoeff();
}

TEST(BandedPencil, FindsTheSmallestEigenvalueOfRandomBeams) {
    constexpr double rounding = 1e-6;    // relative: elements a hundred times as long as others
    std::mt19937 random(8);
    const auto uniform = [&random](double least, double greatest) {
        return std::uniform_real_distribution<double>(least, greatest)(random);
    };
    double worst = 0.0;
    for (int i = 0; i < 200; ++i) {
        constexpr int elements = 16, size = 2 * (elements + 1);
        BandedPencil pencil(size);
        for (int e = 0; e < elements; ++e) {
            const double h = std::pow(10.0, uniform(-2.0, 0.0));
            add_beam(pencil, e, h);
            if (i % 4 != 0)
                add_foundation(pencil, e, h, uniform(0.0, 0.5), uniform(0.5, 1.0), std::pow(10.0, uniform(-3.0, 4.0)));
        }
        pencil.fix(0);
        pencil.fix(i % 2 == 0 ? 1 : 2 * elements);
        const double exact = dense_smallest(pencil, size);
        for (const double bound : {1.001, 2.0, 1e3, 1e6}) {
            const double found = pencil.smallest_eigenvalue(bound * exact, tolerance);
            worst = std::max(worst, std::abs(found / exact - 1.0));
            EXPECT_NEAR(found, exact, rounding * exact) << "beam " << i << ", bound " << bound;
        }
    }
    std::printf("200 random beams, against a dense solver: %.1e at worst\n", worst);
}

// On a stiff foundation a beam held at both ends has loads as close as one in 10⁴, even and odd shapes in turn.
TEST(BandedPencil, FindsTheSmallestOfACluster) {
    constexpr double rounding = 1e-8;    // relative
    constexpr int elements = 64, size = 2 * (elements + 1);
    for (const double kappa : {1e4, 1e5, 1e6, 6.25e6}) {
        BandedPencil pencil(size);
        for (int e = 0; e < elements; ++e) {
            add_beam(pencil, e, 1.0 / elements);
            add_foundation(pencil, e, 1.0 / elements, 0.0, 1.0, kappa);
        }
        pencil.fix(0);
        pencil.fix(2 * elements);
        const double exact = dense_smallest(pencil, size);
        EXPECT_NEAR(pencil.smallest_eigenvalue(4.0 * std::sqrt(kappa), tolerance), exact, rounding * exact) << kappa;
    }
}

TEST(BandedPencil, GivesTheBoundWhereEveryEigenvalueIsAboveIt) {
    constexpr int elements = 8;
    BandedPencil pencil(2 * (elements + 1));
    for (int e = 0; e < elements; ++e) add_beam(pencil, e, 1.0 / elements);
    pencil.fix(0);
    pencil.fix(1);
    EXPECT_EQ(pencil.smallest_eigenvalue(2.0, tolerance), 2.0);    // of π²/4
}

TEST(HermiteBeam, FoundationPiecesAddUpToTheWhole) {
    constexpr double rounding = 1e-14;
    BandedPencil whole(4), pieces(4);
    add_foundation(whole, 0, 0.7, 0.0, 1.0, 420.0);
    add_foundation(pieces, 0, 0.7, 0.0, 0.31, 420.0);
    add_foundation(pieces, 0, 0.7, 0.31, 0.92, 420.0);
    add_foundation(pieces, 0, 0.7, 0.92, 1.0, 420.0);
    const MatrixXd sum = dense(pieces.stiffness, 4), expected = dense(whole.stiffness, 4);
    EXPECT_LT((sum - expected).cwiseAbs().maxCoeff(), rounding * expected.cwiseAbs().maxCoeff());
    EXPECT_NEAR(expected(0, 0), 156.0 * 0.7, rounding * expected(0, 0));    // κh/420 · 156, 22h, −13h
    EXPECT_NEAR(expected(1, 0), 22.0 * 0.49, rounding * expected(0, 0));
    EXPECT_NEAR(expected(3, 0), -13.0 * 0.49, rounding * expected(0, 0));
}

}    // namespace
}    // namespace stylet::winkler
