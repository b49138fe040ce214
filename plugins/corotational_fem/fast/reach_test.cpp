#include "fast/reach.h"

#include "fast/rest_for_tests.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include <cstdio>

namespace stylet::corotational_fem {
namespace {

using namespace testing;

// Against Eigen's answer, and against the panels' own, of which a reach is a part: rounding in single precision alone.
constexpr double rounding_of_single = 6e-8, rounding_of_half = 4.9e-4;
constexpr double gathered = 10.0;    // supernodes come some ten after each other

class ReachTest : public ::testing::TestWithParam<InstructionSet> {
protected:
    void SetUp() override {
        if (!supported(GetParam())) GTEST_SKIP() << "not on this processor";
        panels_ = std::make_unique<Panels>(factor_, smallest_storage(GetParam()), GetParam());
    }

    ReachTest()
        : mesh_(uneven_block({10, 9, 8})),
          matrix_(rest_matrix(mesh_, alike(elastic(25e3, 0.49, 1000.0)), backward_euler(1e-2))),
          dissection_(dissect(matrix_)),
          factor_(dissection_) {
        factor_.refactor(matrix_, one_thread());
    }

    // Nodes less than 15 mm away, by nearness.
    [[nodiscard]] std::vector<NodeWeight> footprint(const Vector3& about) const {
        std::vector<NodeWeight> result;
        double sum = 0.0;
        for (int node = 0; node < mesh_.node_count(); ++node) {
            const double nearness = 0.015 - (mesh_.nodes[node] - about).norm();
            if (nearness <= 0.0) continue;
            result.push_back({node, nearness});
            sum += nearness;
        }
        for (NodeWeight& share : result) share.weight /= sum;
        return result;
    }

    [[nodiscard]] VectorX load(const std::vector<NodeWeight>& footprint, const Vector3& force) const {
        VectorX b = VectorX::Zero(3 * matrix_.rows());
        for (const NodeWeight& share : footprint) {
            if (matrix_.row[share.node] >= 0) b.segment<3>(3 * matrix_.row[share.node]) += share.weight * force;
        }
        return b;
    }

    [[nodiscard]] Vector3 mean(const std::vector<NodeWeight>& footprint, const VectorX& rows) const {
        Vector3 sum = Vector3::Zero();
        for (const NodeWeight& share : footprint) {
            if (matrix_.row[share.node] >= 0) sum += share.weight * rows.segment<3>(3 * matrix_.row[share.node]);
        }
        return sum;
    }

    [[nodiscard]] std::vector<Float4> nodal(const VectorX& rows) const {
        const VectorX places = in_places(dissection_, rows);
        std::vector<Float4> result(dissection_.places() + 1);
        for (int i = 0; i < dissection_.places(); ++i) {
            for (int k = 0; k < 3; ++k) (&result[i].x)[k] = static_cast<float>(places[3 * i + k]);
        }
        return result;
    }

    [[nodiscard]] VectorX backward() const {
        std::vector<Float4> x(dissection_.places() + 1);
        panels_->backward(x.data(), one_thread());
        VectorX places(3 * dissection_.places());
        for (int i = 0; i < dissection_.places(); ++i) places.segment<3>(3 * i) << x[i].x, x[i].y, x[i].z;
        return in_rows(dissection_, places);
    }

    [[nodiscard]] VectorX solve(const VectorX& b) const {
        panels_->forward(nodal(b).data(), one_thread());
        return backward();
    }

    Mesh mesh_;
    BlockMatrix matrix_;
    Dissection dissection_;
    Factor factor_;
    std::unique_ptr<Panels> panels_;
    const Vector3 here_{0.0, 0.01, 0.0}, there_{0.02, 0.0, -0.02}, near_the_bottom_{0.0, 0.0, -0.045};
};

TEST_P(ReachTest, HasTheComplianceOfWholeSolves) {
    for (const Vector3& about : {here_, there_, near_the_bottom_}) {
        const std::vector<NodeWeight> one = footprint(about), other = footprint(here_);
        Reach reach(*panels_), from(*panels_);
        reach.sweep(one);
        from.sweep(other);
        const Matrix3 w = reach.compliance(from), wt = from.compliance(reach);
        Matrix3 own, eigen;
        for (int axis = 0; axis < 3; ++axis) {
            own.col(axis) = mean(one, solve(load(other, Vector3::Unit(axis))));
            eigen.col(axis) = mean(one, solution(matrix_, load(other, Vector3::Unit(axis))));
        }
        const double scale = eigen.norm();
        std::printf("against own solves %.1e, against Eigen %.1e\n", (w - own).norm() / scale, (w - eigen).norm() / scale);
        EXPECT_LT((w - own).norm(), gathered * rounding_of_single * scale);
        EXPECT_LT((w - eigen).norm(), gathered * rounding_of_half * scale);
        EXPECT_LT((w - wt.transpose()).norm(), gathered * rounding_of_single * scale);
    }
}

TEST_P(ReachTest, IsSymmetricBitForBitWithItself) {
    Reach reach(*panels_);
    reach.sweep(footprint(there_));
    const Matrix3 w = reach.compliance(reach);
    EXPECT_EQ(w, w.transpose());
    EXPECT_GT(Eigen::SelfAdjointEigenSolver<Matrix3>(w).eigenvalues().minCoeff(), 0.0);
}

TEST_P(ReachTest, SeesWhatASolveWillBring) {
    const std::vector<NodeWeight> where = footprint(there_);
    Reach reach(*panels_);
    reach.sweep(where);
    const VectorX weight = load(footprint(here_), Vector3(0.1, 0.2, -1.0)) + 1e-3 * noise(3 * matrix_.rows(), 1.0, 1);
    panels_->forward(nodal(weight).data(), one_thread());
    const Vector3 seen = reach.displacement(), come = mean(where, backward());
    std::printf("%.1e\n", (seen - come).norm() / come.norm());
    EXPECT_LT((seen - come).norm(), gathered * rounding_of_single * come.norm());
}

TEST_P(ReachTest, PushesAsALoadWouldHave) {
    const std::vector<NodeWeight> where = footprint(there_), elsewhere = footprint(here_);
    const Vector3 force(0.3, -0.2, 0.5), other(0.0, 0.1, -1.0);
    Reach reach(*panels_);
    reach.sweep(where);
    const VectorX expected = solve(load(elsewhere, other) + load(where, force));
    panels_->forward(nodal(load(elsewhere, other)).data(), one_thread());
    reach.push(force);
    const VectorX pushed = backward();
    EXPECT_LT((pushed - expected).norm(), gathered * rounding_of_single * expected.norm());
    EXPECT_EQ(backward(), pushed);
}

TEST_P(ReachTest, ForgetsItsLastFootprint) {
    Reach moved(*panels_), fresh(*panels_);
    moved.sweep(footprint(here_));
    moved.sweep(footprint(there_));
    fresh.sweep(footprint(there_));
    EXPECT_EQ(moved.compliance(moved), fresh.compliance(fresh));
    EXPECT_EQ(moved.compliance(fresh), fresh.compliance(moved));
}

TEST_P(ReachTest, OfFixedNodesAloneDoesNotMove) {
    Reach fixed(*panels_), free(*panels_);
    EXPECT_EQ(fixed.compliance(fixed), Matrix3::Zero());    // of no footprint as yet
    fixed.sweep(std::vector<NodeWeight>{{0, 0.5}, {1, 0.5}});
    free.sweep(footprint(here_));
    ASSERT_TRUE(mesh_.fixed[0] && mesh_.fixed[1]);
    EXPECT_EQ(fixed.compliance(fixed), Matrix3::Zero());
    EXPECT_EQ(fixed.compliance(free), Matrix3::Zero());
    panels_->forward(nodal(load(footprint(here_), Vector3::Ones())).data(), one_thread());
    EXPECT_EQ(fixed.displacement(), Vector3::Zero());
}

TEST_P(ReachTest, IsAllThatClearedPanelsKnowOf) {
    const std::vector<NodeWeight> spot = footprint({0.0, 0.0, -0.01}), other = footprint({0.03, 0.02, 0.0});
    const Vector3 force(0.3, -0.2, -1.0);
    Reach reach(*panels_);
    reach.sweep(spot);
    panels_->forward(nodal(VectorX::Zero(3 * matrix_.rows())).data(), one_thread());
    reach.push(force);
    const VectorX expected = backward();
    panels_->forward(nodal(load(other, force)).data(), one_thread());
    panels_->clear();
    reach.push(force);
    EXPECT_EQ(backward(), expected);
    EXPECT_GT(expected.norm(), 0.0);
}

INSTANTIATE_TEST_SUITE_P(
    Each, ReachTest, ::testing::Values(InstructionSet::sse2, InstructionSet::avx2, InstructionSet::avx512), [](const auto& with) {
        return std::string(with.param == InstructionSet::sse2 ? "sse2" : with.param == InstructionSet::avx2 ? "avx2" : "avx512");
    });

}    // namespace
}    // namespace stylet::corotational_fem
