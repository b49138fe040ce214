#include "solid/polar.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <cstring>
#include <numbers>
#include <random>

namespace stylet::corotational_fem {
namespace {

constexpr double rounding =
    1e-13;    // of a singular value decomposition by Jacobi rotations: some tens of units in the last place
constexpr double special_orthogonal = 1e-10;    // hard_case 1 asks for it

Matrix3 random_rotation(std::mt19937& random) {
    std::normal_distribution<double> normal;
    return Quaternion(normal(random), normal(random), normal(random), normal(random)).normalized().toRotationMatrix();
}

double off_rotation(const Matrix3& r) {
    return std::max((r.transpose() * r - Matrix3::Identity()).norm(), std::abs(r.determinant() - 1.0));
}

TEST(Polar, FindsTheRotationOfAStretchedAndTurnedBody) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> stretch(0.2, 3.0);
    double worst = 0.0, least_symmetric = 0.0;
    for (int i = 0; i < 1000; ++i) {
        const Matrix3 turned = random_rotation(random), axes = random_rotation(random);
        const Vector3 stretches(stretch(random), stretch(random), stretch(random));
        const Matrix3 stretched = axes * stretches.asDiagonal() * axes.transpose();
        const Polar polar(turned * stretched);
        worst = std::max(worst, (polar.rotation() - turned).norm());
        const Matrix3 back = polar.left * polar.stretches.asDiagonal() * polar.right.transpose();
        least_symmetric = std::max(least_symmetric, (back - turned * stretched).norm());
    }
    std::printf("1000 bodies: rotation off by %.1e, F = U diag(s) V^T by %.1e\n", worst, least_symmetric);
    EXPECT_LE(worst, rounding);
    EXPECT_LE(least_symmetric, rounding);
}

// Hard case 1.
TEST(Polar, OfABodyPressedFlatIsARotation) {
    std::mt19937 random(2);
    for (double thin = 1.0; thin >= 1e-16; thin *= 0.1) {
        double worst = 0.0;
        for (int i = 0; i < 100; ++i) {
            const Vector3 stretches(1.0, 1.0, i == 0 ? 0.0 : thin);
            const Polar polar(random_rotation(random) * stretches.asDiagonal() * random_rotation(random));
            worst = std::max(worst, off_rotation(polar.rotation()));
        }
        std::printf("diag(1, 1, %.0e): off SO(3) by %.1e\n", thin, worst);
        EXPECT_LE(worst, special_orthogonal);
    }
}

TEST(Polar, OfAThreadAndOfAPointIsARotation) {
    std::mt19937 random(3);
    for (const Vector3& stretches : {Vector3(1.0, 0.0, 0.0), Vector3(0.0, 0.0, 0.0), Vector3(1e-200, 1e-300, 0.0)}) {
        const Matrix3 deformation = random_rotation(random) * stretches.asDiagonal() * random_rotation(random);
        const Polar polar(deformation);
        EXPECT_LE(off_rotation(polar.rotation()), special_orthogonal) << stretches.transpose();
        EXPECT_TRUE(polar.stretches.allFinite());
    }
}

// Hard case 2.
TEST(Polar, OfAnInvertedBodyIsARotationAndTheSameEachTime) {
    const Matrix3 half_turn = Eigen::AngleAxisd(std::numbers::pi, Vector3(1.0, 2.0, 3.0).normalized()).toRotationMatrix();
    const Matrix3 inverted = Vector3(1.0, 1.0, -0.2).asDiagonal();
    for (const Matrix3& deformation : {inverted, Matrix3(-Matrix3::Identity()), half_turn, Matrix3(half_turn * inverted)}) {
        const Polar polar(deformation);
        const Matrix3 rotation = polar.rotation();
        std::printf("det F = %5.2f: det R - 1 = %.1e, stretches %.3f %.3f %.3f\n", deformation.determinant(),
                    rotation.determinant() - 1.0, polar.stretches[0], polar.stretches[1], polar.stretches[2]);
        EXPECT_LE(off_rotation(rotation), rounding);
        EXPECT_LE((rotation * (polar.right * polar.stretches.asDiagonal() * polar.right.transpose()) - deformation).norm(),
                  rounding);
        for (int again = 0; again < 10; ++again) {
            const Matrix3 same = Polar(deformation).rotation();
            EXPECT_EQ(std::memcmp(same.data(), rotation.data(), sizeof(Matrix3)), 0);
        }
    }
}

TEST(Polar, TurnsAnInvertedBodyBackTheShortestWay) {
    const Polar polar(Vector3(1.0, 1.0, -0.2).asDiagonal());
    EXPECT_LE((polar.rotation() - Matrix3::Identity()).norm(), rounding);    // only the least stretch is negative
    EXPECT_DOUBLE_EQ(polar.stretches[2], -0.2);
}

TEST(Polar, TurnsAsItsTwistsSay) {
    std::mt19937 random(4);
    std::uniform_real_distribution<double> stretch(0.2, 3.0), direction(-1.0, 1.0);
    constexpr double step = 1e-6;
    constexpr double difference = 1e-8;    // central: step² truncated, 1e-16/step rounded, times the stretches' inverses
    double worst = 0.0;
    for (int i = 0; i < 200; ++i) {
        const double flip = i % 2 == 0 ? 1.0 : -0.3;    // every other one inverted
        const Vector3 stretches(3.0 + stretch(random), 1.5 + 0.4 * stretch(random), flip);
        const Matrix3 deformation = random_rotation(random) * stretches.asDiagonal() * random_rotation(random);
        const Matrix3 change = Matrix3::NullaryExpr([&] { return direction(random); });
        const Polar polar(deformation);
        Matrix3 promised = Matrix3::Zero();
        for (int k = 0; k < 3; ++k) {
            promised += 2.0 / polar.across(k) * polar.twist(k).cwiseProduct(change).sum() * polar.twist(k);
        }
        const Matrix3 found =
            (Polar(deformation + step * change).rotation() - Polar(deformation - step * change).rotation()) / (2.0 * step);
        worst = std::max(worst, (found - promised).norm());
    }
    std::printf("200 rotations: derivative off by %.1e\n", worst);
    EXPECT_LE(worst, difference);
}

}    // namespace
}    // namespace stylet::corotational_fem
