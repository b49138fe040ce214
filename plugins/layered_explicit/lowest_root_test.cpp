#include "lowest_root.h"

#include <Eigen/Eigenvalues>

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace stylet::layered_explicit {
namespace {

constexpr double rounding = 1e-14;    // of the largest eigenvalue

TEST(LowestRoot, IsThatOfAnEigensolver) {
    std::mt19937 random(3);
    std::normal_distribution<double> normal;
    for (int i = 0; i < 1000; ++i) {
        Matrix3 root;
        for (double& entry : root.reshaped()) entry = normal(random);
        Matrix3 matrix = root * root.transpose() + Matrix3::Identity();
        if (i % 3 == 0) matrix = Matrix3(matrix.diagonal().asDiagonal());
        const Eigen::SelfAdjointEigenSolver<Matrix3> three(matrix, Eigen::EigenvaluesOnly);
        const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> two(matrix.topLeftCorner<2, 2>(), Eigen::EigenvaluesOnly);
        EXPECT_NEAR(lowest_root(matrix), three.eigenvalues()[0], rounding * three.eigenvalues()[2]);
        EXPECT_NEAR(lowest_root(matrix(0, 0), matrix(0, 1), matrix(1, 1)), two.eigenvalues()[0], rounding * two.eigenvalues()[1]);
    }
}

TEST(LowestRoot, OfEqualEigenvaluesIsThatValue) {
    EXPECT_EQ(lowest_root(2.0 * Matrix3::Identity()), 2.0);
    EXPECT_EQ(lowest_root(2.0, 0.0, 2.0), 2.0);
    const Matrix3 two_equal = Vector3(1.0, 1.0, 4.0).asDiagonal();
    EXPECT_NEAR(lowest_root(two_equal), 1.0, 1e-7);    // a double root of a cubic moves by the square root of a rounding
}

}    // namespace
}    // namespace stylet::layered_explicit
